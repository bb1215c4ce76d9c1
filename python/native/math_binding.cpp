#include "python/native/math_binding.h"

#include <elf.h>
#include <link.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <string_view>

#include "python/native/math_names.h"

// Declared by their names alone: the addresses count here, not the types.
#define UNIETP_DECLARE(name) extern "C" __attribute__((visibility("hidden"))) void own_##name() __asm__(#name);
UNIETP_EACH_MATH_FUNCTION(UNIETP_DECLARE)
#undef UNIETP_DECLARE

namespace unietp::python {
namespace {

std::uintptr_t own_function(std::string_view name) {
#define UNIETP_ENTRY(name) {#name, reinterpret_cast<std::uintptr_t>(&own_##name)},
  static const std::map<std::string_view, std::uintptr_t> functions{UNIETP_EACH_MATH_FUNCTION(UNIETP_ENTRY)};
#undef UNIETP_ENTRY
  const auto found = functions.find(name);
  return found == functions.end() ? 0 : found->second;
}

/// A loaded shared library (System V ABI, chapter 5).
struct Library {
  std::string file, soname;
  std::vector<std::string> needs;
  std::uintptr_t base = 0;
  const ElfW(Sym) * symbols = nullptr;
  const char* strings = nullptr;
  std::span<const ElfW(Rela)> relocations, calls;
  std::uintptr_t read_only_begin = 0, read_only_end = 0;  // protected after relocation
};

Library library_of(const dl_phdr_info& info) {
  Library library;
  library.file = std::filesystem::path(info.dlpi_name).filename();
  library.base = info.dlpi_addr;
  const ElfW(Dyn)* entry = nullptr;
  for (const auto& header : std::span(info.dlpi_phdr, info.dlpi_phnum)) {
    if (header.p_type == PT_DYNAMIC) entry = reinterpret_cast<const ElfW(Dyn)*>(info.dlpi_addr + header.p_vaddr);
    if (header.p_type == PT_GNU_RELRO) {
      library.read_only_begin = info.dlpi_addr + header.p_vaddr;
      library.read_only_end = library.read_only_begin + header.p_memsz;
    }
  }
  std::map<ElfW(Sxword), ElfW(Xword)> values;
  std::vector<ElfW(Xword)> needs;
  for (; entry != nullptr && entry->d_tag != DT_NULL; ++entry) {
    if (entry->d_tag == DT_NEEDED) needs.push_back(entry->d_un.d_val);
    values[entry->d_tag] = entry->d_un.d_val;
  }
  if (values[DT_STRTAB] < info.dlpi_addr) return library;  // the kernel's vDSO, which glibc does not relocate
  library.strings = reinterpret_cast<const char*>(values[DT_STRTAB]);
  library.symbols = reinterpret_cast<const ElfW(Sym)*>(values[DT_SYMTAB]);
  const auto table = [&](ElfW(Sxword) place, ElfW(Sxword) bytes) {
    return std::span(reinterpret_cast<const ElfW(Rela)*>(values[place]), values[bytes] / sizeof(ElfW(Rela)));
  };
  library.relocations = table(DT_RELA, DT_RELASZ);
  if (values[DT_PLTREL] == DT_RELA) library.calls = table(DT_JMPREL, DT_PLTRELSZ);
  if (values.contains(DT_SONAME)) library.soname = library.strings + values[DT_SONAME];
  for (const auto name : needs) library.needs.emplace_back(library.strings + name);
  return library;
}

/// This module and what it needs, directly or not, in the order of loading.
std::vector<Library> needed_libraries() {
  std::vector<Library> loaded;
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* list) {
        static_cast<std::vector<Library>*>(list)->push_back(library_of(*info));
        return 0;
      },
      &loaded);
  ::Dl_info self{};
  ::dladdr(reinterpret_cast<const void*>(&needed_libraries), &self);
  std::set<std::string> wanted;
  std::vector<std::string> open;
  const auto want = [&](const Library& library) {
    for (const auto& name : library.needs) {
      if (wanted.insert(name).second) open.push_back(name);
    }
  };
  for (const auto& library : loaded) {
    if (library.base == reinterpret_cast<std::uintptr_t>(self.dli_fbase)) want(library);
  }
  while (!open.empty()) {
    const auto name = open.back();
    open.pop_back();
    for (const auto& library : loaded) {
      if (library.soname == name) want(library);
    }
  }
  std::erase_if(loaded, [&](const Library& library) { return !wanted.contains(library.soname); });
  return loaded;
}

/// Calls visit(name, slot, value it should hold) for each slot that the loader fills with the address of a
/// mathematical function.
template <class Visit>
void for_each_slot(const Library& library, Visit visit) {
#if defined(__x86_64__)
  constexpr std::array<std::uint32_t, 3> kAddresses{R_X86_64_JUMP_SLOT, R_X86_64_GLOB_DAT, R_X86_64_64};
#elif defined(__aarch64__)
  constexpr std::array<std::uint32_t, 3> kAddresses{R_AARCH64_JUMP_SLOT, R_AARCH64_GLOB_DAT, R_AARCH64_ABS64};
#else
#error "name the relocations of this processor that hold the address of a function"
#endif
  for (const auto& relocations : {library.relocations, library.calls}) {
    for (const auto& relocation : relocations) {
      const auto type = static_cast<std::uint32_t>(ELF64_R_TYPE(relocation.r_info));
      if (std::ranges::find(kAddresses, type) == kAddresses.end()) continue;
      const char* name = library.strings + library.symbols[ELF64_R_SYM(relocation.r_info)].st_name;
      if (const auto function = own_function(name); function != 0) {
        visit(name, reinterpret_cast<std::uintptr_t*>(library.base + relocation.r_offset),
              function + static_cast<std::uintptr_t>(relocation.r_addend));
      }
    }
  }
}

void protect(const Library& library, int access) {
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const auto begin = library.read_only_begin / page * page, end = library.read_only_end / page * page;
  if (begin >= end) return;
  if (::mprotect(reinterpret_cast<void*>(begin), end - begin, access) != 0) {
    throw std::runtime_error("cannot bind the mathematical functions of " + library.file + ": " + std::strerror(errno));
  }
}

}  // namespace

void bind_math_functions() {
  for (const auto& library : needed_libraries()) {
    bool all_own = true;
    for_each_slot(library, [&](const char*, const std::uintptr_t* slot, std::uintptr_t own) {
      all_own = all_own && *slot == own;
    });
    if (all_own) continue;
    protect(library, PROT_READ | PROT_WRITE);
    for_each_slot(library, [](const char*, std::uintptr_t* slot, std::uintptr_t own) { *slot = own; });
    protect(library, PROT_READ);
  }
}

std::vector<MathBinding> math_bindings() {
  std::vector<MathBinding> bindings;
  for (const auto& library : needed_libraries()) {
    for_each_slot(library, [&](const char* name, const std::uintptr_t* slot, std::uintptr_t own) {
      bindings.push_back({library.file, name, *slot == own});
    });
  }
  return bindings;
}

}  // namespace unietp::python
