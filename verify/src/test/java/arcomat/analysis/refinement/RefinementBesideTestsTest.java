package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomNetworks;
import arcomat.analysis.RandomPairs;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Moment;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.SmallType;
import arcomat.simulate.RandomSliceModels;
import arcomat.simulate.RecordedRuns;
import arcomat.simulate.run.Choice;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTests;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Refinement and stream tests mean the same by "allowed": where it holds, tests of the right side
 * pass on what the left one does; where it fails, the counterexample is a test that the left side
 * passes and the right side does not. More with {@code -Dmodels=1000}, others with {@code
 * -Dfirst=7}.
 */
class RefinementBesideTestsTest {
    private static final int MODELS = Integer.getInteger("models", 40);
    private static final int FIRST = Integer.getInteger("first", 0);

    @Test
    void atomicComponents() {
        RandomPairs.any(FIRST, MODELS)
                .forEach(pair -> agree(pair.left(), pair.right(), pair.toString()));
    }

    @Test
    void componentsWithSeveralAutomata() {
        RandomPairs.conjunctions(FIRST, MODELS)
                .forEach(each -> agree(each.left(), each.right(), each.toString()));
    }

    @Tag("slow")
    @Test
    void compositions() {
        RandomNetworks random = new RandomNetworks(FIRST);
        for (int i = 0; i < MODELS; i++) {
            RandomNetworks.Question question = random.question();
            agree(question.left(), question.right(), question.text());
        }
    }

    @Tag("slow")
    @Test
    void compositionsWithRangesAndGuards() {
        for (int seed = FIRST; seed < FIRST + MODELS; seed++) {
            Component one = RandomSliceModels.of(seed, false);
            Component other = RandomSliceModels.edited(seed, seed);
            String text = "seed " + seed + "\n" + RandomSliceModels.text(seed, false);
            agree(Promise.of(one, List.of()), Promise.of(other, List.of()), text);
            agree(Promise.of(other, List.of()), Promise.of(one, List.of()), text);
        }
    }

    private static void agree(Promise left, Promise right, String text) {
        Verdict verdict =
                Refinement.check(left, right, new Budget(() -> false, 20_000).patient(300_000));
        if (verdict.answer() == Answer.HOLDS) {
            for (int seed = 0; seed < 5; seed++) {
                Choice choice = Choice.randomThroughout(seed);
                Trace trace = RecordedRuns.run(left.component(), choice, seed, 8);
                if (trace.steps().isEmpty()) {
                    continue;
                }
                StreamTest test = RecordedRuns.test(trace, right.component());
                assertThat(StreamTests.run(test).verdict())
                        .as(() -> text + "\n" + test.inputs() + test.expected())
                        .isNotEqualTo(StreamTestResult.Verdict.FAILED);
            }
        }
        if (verdict.answer() == Answer.FAILS && verdict.reason().equals("behaviour")) {
            counterexample(left, right, verdict.trace(), text);
        }
    }

    private static void counterexample(
            Promise left, Promise right, List<Moment> trace, String text) {
        boolean error = trace.get(trace.size() - 1).error();
        boolean found = false;
        List<Map<String, List<List<Value>>>> written = new ArrayList<>();
        int moments = error ? trace.size() - 1 : trace.size();
        for (Map<String, List<List<Value>>> streams : streams(left, right, trace, moments)) {
            List<Letter> inputs = new ArrayList<>();
            trace.subList(Math.min(1, moments), moments)
                    .forEach(moment -> inputs.add(moment.input()));
            StreamTest mine = RecordedRuns.test(left.component(), inputs, streams);
            StreamTest theirs = RecordedRuns.test(right.component(), inputs, streams);
            written.add(streams);
            found |= moments == 0 || passes(mine) && (error ? passes(theirs) : !passes(theirs));
        }
        assertThat(found).as(() -> text + "\n" + trace + "\n" + written).isTrue();
    }

    private static boolean passes(StreamTest test) {
        StreamTestResult.Verdict verdict = StreamTests.run(test).verdict();
        assertThat(verdict).isNotEqualTo(StreamTestResult.Verdict.UNKNOWN);
        return verdict != StreamTestResult.Verdict.FAILED;
    }

    /** The streams of a trace, with every message that is left open in it. */
    private static List<Map<String, List<List<Value>>>> streams(
            Promise left, Promise right, List<Moment> trace, int moments) {
        Set<String> late = late(left, right);
        List<Map<String, List<List<Value>>>> all = List.of(new LinkedHashMap<>());
        for (int i = 0; i < moments; i++) {
            for (Map.Entry<String, Sent> each : trace.get(i).outputs().entrySet()) {
                boolean both =
                        left.component().port(each.getKey()).isPresent()
                                && right.component().port(each.getKey()).isPresent();
                if (!both || i == 0 && !late.contains(each.getKey())) {
                    continue;
                }
                List<Map<String, List<List<Value>>>> longer = new ArrayList<>();
                for (List<Value> messages : messages(each.getValue(), right, each.getKey())) {
                    for (Map<String, List<List<Value>>> streams : all) {
                        Map<String, List<List<Value>>> copy = new LinkedHashMap<>();
                        streams.forEach((port, stream) -> copy.put(port, new ArrayList<>(stream)));
                        copy.computeIfAbsent(each.getKey(), key -> new ArrayList<>()).add(messages);
                        longer.add(copy);
                    }
                }
                all = longer;
            }
        }
        return all;
    }

    private static List<List<Value>> messages(Sent sent, Promise side, String port) {
        if (sent instanceof Sent.Messages messages) {
            return List.of(messages.values());
        }
        List<List<Value>> all = new ArrayList<>();
        if (sent.allows(List.of())) {
            all.add(List.of());
        }
        Port type = side.component().port(port).orElseThrow();
        SmallType.values(type.type()).orElseThrow().forEach(value -> all.add(List.of(value)));
        return all;
    }

    /** Ports that show on both sides what was sent in the slice before. */
    private static Set<String> late(Promise left, Promise right) {
        Set<String> late = late(left);
        late.retainAll(late(right));
        return late;
    }

    private static Set<String> late(Promise side) {
        Network network = Network.of(side.component(), side.arguments());
        Set<String> late = new HashSet<>();
        for (Network.External output : network.outputs()) {
            if (network.delayed().contains(output.signal())) {
                late.add(output.name());
            }
        }
        return late;
    }
}
