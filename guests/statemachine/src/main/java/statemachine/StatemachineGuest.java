package statemachine;

import arcomat.guest.BehaviourLanguage;
import arcomat.guest.Guest;

import java.util.List;

/** Brings hierarchical state machines. */
public final class StatemachineGuest implements Guest {
    @Override
    public int api() {
        return API;
    }

    @Override
    public String name() {
        return "statemachine";
    }

    @Override
    public List<BehaviourLanguage> languages() {
        return List.of(new StatemachineLanguage());
    }
}
