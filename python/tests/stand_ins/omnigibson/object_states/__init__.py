"""OmniGibson's object states by name, without geometry: a thing is where it was put, and as warm as its surroundings made it."""

ROOM_C, FREEZING_C, HOT_C, BURNING_C = 23.0, 0.0, 40.0, 200.0  # the defaults of OmniGibson 1.1.1


class State:
    def __init__(self, obj, **parameters):
        self.obj, self.parameters = obj, parameters

    @classmethod
    def of(cls, obj):
        return obj.states[cls]


class Boolean(State):
    value = False

    def get_value(self):
        return self.value

    def set_value(self, value):
        self.value = value
        return True


class Open(Boolean): ...


class Folded(Boolean):
    def set_value(self, value):
        Unfolded.of(self.obj).value = not value
        return super().set_value(value)


class Unfolded(Boolean): ...


class ToggledOn(Boolean):
    def set_value(self, value):
        is_open = Open in self.obj.states and Open.of(self.obj).get_value()
        if value and self.parameters.get("requires_closed") and is_open:
            return False
        return super().set_value(value)


class Temperature(State):
    value = ROOM_C

    def get_value(self):
        return self.value

    def set_value(self, value):
        self.value = value
        MaxTemperature.of(self.obj).value = max(value, MaxTemperature.of(self.obj).value)
        return True


class MaxTemperature(State):
    value = ROOM_C


class Heated(State):
    def get_value(self):
        return Temperature.of(self.obj).value >= HOT_C

    def set_value(self, value):
        return Temperature.of(self.obj).set_value(HOT_C + 15 if value else ROOM_C)  # OmniGibson draws 10 to 20 more


class Frozen(State):
    def get_value(self):
        return Temperature.of(self.obj).value <= FREEZING_C

    def set_value(self, value):
        return Temperature.of(self.obj).set_value(FREEZING_C - 20 if value else ROOM_C)


class Cooked(State):
    def _limit(self):
        return self.parameters.get("cook_temperature", 70.0)

    def get_value(self):
        return MaxTemperature.of(self.obj).value >= self._limit()

    def set_value(self, value):
        MaxTemperature.of(self.obj).value = self._limit() if value else min(MaxTemperature.of(self.obj).value, self._limit() - 1)
        return True


class Burnt(Cooked):
    def _limit(self):
        return BURNING_C


class OnSystem(State):
    """Of a thing and a substance."""

    def __init__(self, obj, **parameters):
        super().__init__(obj, **parameters)
        self.names = set()

    def get_value(self, system):
        return system.name in self.names

    def set_value(self, system, value):
        (self.names.add if value else self.names.discard)(system.name)
        return True


class Covered(OnSystem): ...


class Saturated(OnSystem): ...


class Filled(OnSystem):
    def set_value(self, system, value):
        Contains.of(self.obj).names = {system.name} if value else set()
        return super().set_value(system, value)


class Contains(OnSystem):
    def set_value(self, system, value):
        if not value:
            Filled.of(self.obj).names.discard(system.name)
        return super().set_value(system, value)


class Relation(State):
    """Of two things; true of where the first was put."""

    def get_value(self, other):
        return self.obj.place == (type(self), other)

    def set_value(self, other, value):
        self.obj.place = (type(self), other) if value else None
        return True


class OnTop(Relation): ...


class Inside(Relation):
    def get_value(self, other):
        """Also of what rests on or in a thing that is inside."""
        place = self.obj.place
        while place is not None:
            kind, thing = place
            if kind is Inside and thing is other:
                return True
            place = thing.place
        return False


class AttachedTo(Relation): ...


class Under(Relation): ...


class NextTo(Relation): ...


class Touching(Relation): ...


class Overlaid(Relation): ...


class Draped(Relation): ...


class OnFire(Boolean): ...


class IsGrasping(State):
    def get_value(self, thing):
        return self.obj._ag_obj_in_hand["0"] is thing


class HeatSourceOrSink(State):
    def __init__(self, obj, **parameters):
        super().__init__(obj, **parameters)
        self.requires_inside = bool(parameters.get("requires_inside"))
        self.temperature, self.heating_rate = parameters["temperature"], parameters["heating_rate"]

    def is_on(self):
        states = self.obj.states
        if self.parameters.get("requires_toggled_on") and not (ToggledOn in states and states[ToggledOn].get_value()):
            return False
        return not (self.parameters.get("requires_closed") and Open in states and states[Open].get_value())


class ParticleRemover(State):
    @property
    def conditions(self):
        return {self.obj.scene.named(synset): rows for synset, rows in self.parameters["conditions"].items()}

    def supports_system(self, name):
        return self.conditions.get(name) is not None or name not in self.conditions

    def check_conditions_for_system(self, name):
        """One of the rows, each of which is a state and a substance."""
        rows = self.conditions.get(name)
        scene, wet = self.obj.scene, Saturated.of(self.obj)
        return not rows or any(wet.get_value(scene.get_system(scene.named(substance))) for _, substance in rows)


class ParticleSource(State):
    def check_conditions_for_system(self, name):
        conditions = {self.obj.scene.named(synset): rows for synset, rows in self.parameters["conditions"].items()}
        rows = conditions.get(name)
        return rows is not None and all(ToggledOn.of(self.obj).get_value() == value for _, value in rows)


# What each ability of BEHAVIOR's taxonomy gives a thing (omnigibson/object_states/factory.py), with what these need.
OF_ALL = (OnTop, Inside, Under, NextTo, Touching, AttachedTo, Covered)
OF_ABILITY = {
    "openable": (Open,), "toggleable": (ToggledOn,), "cookable": (Temperature, MaxTemperature, Cooked, Burnt),
    "freezable": (Temperature, MaxTemperature, Frozen), "heatable": (Temperature, MaxTemperature, Heated),
    "fillable": (Filled, Contains), "cloth": (Folded, Unfolded, Overlaid, Draped), "flammable": (OnFire,),
    "particleRemover": (ParticleRemover, Saturated), "particleSource": (ParticleSource,), "heatSource": (HeatSourceOrSink,),
    "coldSource": (HeatSourceOrSink,),
}  # fmt: skip
