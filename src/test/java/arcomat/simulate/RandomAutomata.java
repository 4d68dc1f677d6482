package arcomat.simulate;

import static arcomat.semantics.ComponentBuilder.BOOLEAN;
import static arcomat.semantics.ComponentBuilder.MOTOR;

import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.semantics.ComponentBuilder;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;

import java.util.List;

/** Arbitrary automata with a Boolean and a motor input and one output of each. */
public final class RandomAutomata {
    private static final String[] STATES = {"s0", "s1", "s2"};

    private RandomAutomata() {}

    /** A transition in the short form of {@link ComponentBuilder}. */
    private record Line(String move, String input, String output) {}

    /** What differs between two automata of the same lines. */
    public interface Recipe {
        Component with(Completion completion, boolean instant);
    }

    public static Arbitrary<Recipe> recipes() {
        return lines().list().ofMinSize(1).ofMaxSize(8).map(lines -> (c, i) -> build(lines, c, i));
    }

    public static Arbitrary<Component> components() {
        return Combinators.combine(
                        recipes(),
                        Arbitraries.of(Completion.CHAOS, Completion.OUTPUT, Completion.IGNORE),
                        Arbitraries.of(true, false))
                .as(Recipe::with);
    }

    private static Arbitrary<Line> lines() {
        Arbitrary<String> states = Arbitraries.of(STATES);
        Arbitrary<String> inputs =
                Arbitraries.of(
                        "", "a = true", "a = --", "b = fwd", "a = ?, b = stop", "b = fwd|stop");
        Arbitrary<String> outputs =
                Arbitraries.of("", "x = true", "y = fwd", "x = false, y = stop", "y = --");
        return Combinators.combine(states, states, inputs, outputs)
                .as((from, to, in, out) -> new Line(from + " -> " + to, in, out));
    }

    private static Component build(List<Line> lines, Completion completion, boolean instant) {
        ComponentBuilder builder =
                ComponentBuilder.component("Random").in(BOOLEAN, "a").in(MOTOR, "b");
        builder =
                instant
                        ? builder.instantOut(BOOLEAN, "x").instantOut(MOTOR, "y")
                        : builder.out(BOOLEAN, "x").out(MOTOR, "y");
        ComponentBuilder.AutomatonBuilder automaton = builder.automaton(completion, STATES);
        automaton.initial("s0", instant ? "" : "y = stop");
        lines.forEach(line -> automaton.on(line.move, line.input, line.output));
        return automaton.build();
    }
}
