package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.Draft;
import arcomat.analysis.Draft.Opening;
import arcomat.analysis.Draft.Socket;
import arcomat.analysis.NaiveInclusion;
import arcomat.analysis.NaiveLateMachine;
import arcomat.analysis.NaiveMachine;
import arcomat.analysis.RandomNetworks;
import arcomat.analysis.RandomNetworks.Question;
import arcomat.analysis.Sketch.Edge;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.product.TraceInclusion;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.semantics.ComponentBuilder;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.OptionalInt;

/**
 * Questions whose left sides have been slowed down, by parts that pass on what they get: the engine
 * beside naive enumeration.
 */
class LatencyTest {
    private static final int LENGTH = 4;
    private static final int QUESTIONS = 28;

    private static final Draft PASS =
            new Draft(
                    List.of(new Socket("x", true, false, 0), new Socket("u", false, false, 1)),
                    Completion.IGNORE,
                    false,
                    1,
                    List.of(new Opening(0, "")),
                    List.of(new Edge(0, 0, "x = m", "u = m"), new Edge(0, 0, "x = n", "u = n")));

    @Tag("slow")
    @Test
    void agreesWithNaiveEnumeration() {
        RandomNetworks random = new RandomNetworks(61);
        int kept = 0;
        int failed = 0;
        while (kept + failed < QUESTIONS) {
            Question question = random.question();
            if (question.left().component().inputs().stream().anyMatch(Port::total)) {
                continue; // Nothing can be passed on late and be there from the start.
            }
            int slices = 1 + (kept + failed) % 2;
            Promise left = slowed(question.left(), slices);
            ComparedSystems sides = ComparedSystems.of(left, question.right(), Budget.ofMemory());
            TraceInclusion.Result result = Latency.compare(sides, slices, Budget.ofMemory());
            OptionalInt naive =
                    new NaiveInclusion(
                                    left,
                                    question.right(),
                                    new NaiveLateMachine(NaiveMachine.of(question.right()), slices))
                            .shortestFailure(LENGTH);
            assertThat(result.stopped()).isEmpty();
            assertThat(engine(result)).as(question.text()).isEqualTo(naive);
            kept += result.failure().isPresent() ? 0 : 1;
            failed += result.failure().isPresent() ? 1 : 0;
        }
        assertThat(kept).isGreaterThan(QUESTIONS / 8);
        assertThat(failed).isGreaterThan(QUESTIONS / 8);
    }

    private static OptionalInt engine(TraceInclusion.Result result) {
        int level = result.failure().map(TraceInclusion.Failure::level).orElse(Integer.MAX_VALUE);
        return level <= LENGTH ? OptionalInt.of(level) : OptionalInt.empty();
    }

    /** Behind a row of delays at each input. */
    private static Promise slowed(Promise promise, int slices) {
        Component whole = promise.component();
        ComponentBuilder slow = ComponentBuilder.component("Slow");
        whole.ports().forEach(port -> socket(port).add(slow));
        slow.part("whole", whole);
        for (Port input : whole.inputs()) {
            String sender = input.name();
            for (int i = 0; i < slices; i++) {
                String part = "late" + i + input.name();
                slow.part(part, PASS.component("Pass"));
                slow.connect(sender, part + ".x");
                sender = part + ".u";
            }
            slow.connect(sender, "whole." + input.name());
        }
        whole.outputs().forEach(port -> slow.connect("whole." + port.name(), port.name()));
        return Promise.of(slow.build(), List.of());
    }

    private static Socket socket(Port port) {
        return new Socket(port.name(), port.isInput(), port.total(), port.delay());
    }
}
