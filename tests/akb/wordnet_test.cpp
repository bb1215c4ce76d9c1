// Every synset that the tables name is one of WordNet 3.0's, read from Debian's wordnet-base.
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "akb/tables.h"
#include "core/text.h"
#include "tests/support/needs.h"
