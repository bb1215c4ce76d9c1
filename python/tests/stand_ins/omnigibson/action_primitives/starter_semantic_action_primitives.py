"""What OmniGibson's symbolic primitives take from those with arms and wheels, without either."""

from omnigibson import object_states
from omnigibson.action_primitives.action_primitive_set_base import BaseActionPrimitiveSet

SETTLING_STEPS = 30


class StarterSemanticActionPrimitives(BaseActionPrimitiveSet):
    arm = "0"

    def get_action_space(self):
        raise NotImplementedError

    def apply(self, action):
        raise NotImplementedError

    def _get_obj_in_hand(self):
        return self.robot._ag_obj_in_hand[self.arm]

    def _empty_action(self):
        return None

    def _settle_robot(self):
        for _ in range(SETTLING_STEPS):
            yield self._empty_action()

    def _open(self, obj):
        yield from self._open_or_close(obj, True)

    def _close(self, obj):
        yield from self._open_or_close(obj, False)

    def _toggle_on(self, obj):
        yield from self._toggle(obj, True)

    def _toggle_off(self, obj):
        yield from self._toggle(obj, False)

    def _place_on_top(self, obj):
        yield from self._place_with_predicate(obj, object_states.OnTop)

    def _place_inside(self, obj):
        yield from self._place_with_predicate(obj, object_states.Inside)

    def _sample_pose_with_object_and_predicate(self, predicate, held_obj, target_obj, **_):
        return (predicate, target_obj), None

    def _navigate_to_obj(self, obj):
        self.robot.room = obj.room() or self.robot.room
        yield from self._settle_robot()
