package arcomat.analysis.game.controller;

import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.expression.Output;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;

import org.jspecify.annotations.Nullable;

import java.util.List;

/**
 * A system that keeps the requirements, state by state; state 0 is the first one. It is
 * deterministic: every input has one reaction.
 *
 * @param opening what is sent before anything is read
 */
public record MealyMachine(
        List<Port> inputs, List<Port> outputs, Output opening, List<State> states) {
    public MealyMachine {
        states = List.copyOf(states);
    }

    /**
     * What is done after an input.
     *
     * @param sent null where the run ends, because the requirements forbid the input
     */
    public record Reaction(@Nullable Output sent, int next) {}

    /**
     * The reactions of one state. Inputs are told apart port by port.
     *
     * @param name of what the requirements are in; empty where that has no names
     * @param looks per input port how it is looked at
     * @param samples per input port one message of each kind, null for none
     * @param reactions one per combination of samples; those of the last port change fastest
     */
    public record State(
            String name,
            List<PortAbstraction> looks,
            List<List<Value>> samples,
            List<Reaction> reactions) {}
}
