package arcomat.analysis.coverage;

import arcomat.analysis.coverage.ReachabilityGraph.Beginning;
import arcomat.analysis.coverage.ReachabilityGraph.Node;
import arcomat.analysis.coverage.ReachabilityGraph.Step;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.StreamTest;
import arcomat.model.Value;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Stream tests that together take every transition of an atomic component that can be taken, and go
 * on after it until its absence would show, where that is possible; and further ones that tell it
 * from components with a small mistake. A test is extended for as long as going on is not longer
 * than beginning anew, so that tests are few and words short. What a test expects is one of the
 * runs that the model allows; what that run leaves open is expected as it is sent by code: nothing,
 * or the first value where there is a message.
 */
public final class TransitionTests {

    /**
     * A test with what it is there for.
     *
     * @param covers the transitions that no earlier test takes, in the order in which it takes them
     * @param tells the mistake that it is there for: a transition, and what may have become of it;
     *     empty for a test that is there for what it covers
     * @param promised whether the component promises something to its end; else it ends in chaos,
     *     and what it expects there is what code does
     */
    public record Test(
            StreamTest streams, List<Goal> covers, Optional<Mistake> tells, boolean promised) {
        public Test {
            covers = List.copyOf(covers);
        }
    }

    /**
     * A small mistake in a transition.
     *
     * @param what becomes of the transition, in words
     */
    public record Mistake(Goal transition, String what) {}

    /**
     * A mistake that no test tells, though the component then does less than it should.
     *
     * @param reason why there is no test that does
     * @param certain whether that is sure; else it is not known whether there could be one
     */
    public record Untold(Mistake mistake, String reason, boolean certain) {}

    /** Mistakes in one transition that no test tells, for one reason. */
    public record Gap(Goal transition, List<String> mistakes, String reason, boolean certain) {
        public Gap {
            mistakes = List.copyOf(mistakes);
        }

        /** {@code is missing, or sends nothing on 'y'}; what is said twice is counted. */
        public String words() {
            Map<String, Integer> counts = new LinkedHashMap<>();
            mistakes.forEach(each -> counts.merge(each, 1, Integer::sum));
            return counts.entrySet().stream()
                    .map(each -> each.getKey() + places(each.getValue()))
                    .collect(Collectors.joining(", or "));
        }

        private static String places(int count) {
            return count == 1 ? "" : " (in %d places)".formatted(count);
        }
    }

    /**
     * A transition that no test takes, and why.
     *
     * @param certain whether no test can take it
     */
    public record Uncovered(Goal transition, String reason, boolean certain) {}

    /**
     * @param transitions how many there are
     * @param stopped why the search ended early; then a transition that is not covered may still be
     *     one that can be taken
     * @param configurations how many were looked at
     */
    public record Result(
            List<Test> tests,
            int transitions,
            List<Uncovered> uncovered,
            List<Untold> untold,
            Optional<String> stopped,
            int configurations) {
        public Result {
            tests = List.copyOf(tests);
            uncovered = List.copyOf(uncovered);
            untold = List.copyOf(untold);
        }

        /** Mistakes that no test tells, those together that differ in no more than the mistake. */
        public List<Gap> gaps() {
            Map<List<Object>, Gap> gaps = new LinkedHashMap<>();
            for (Untold each : untold) {
                Goal goal = each.mistake().transition();
                Gap gap =
                        new Gap(
                                goal,
                                List.of(each.mistake().what()),
                                each.reason(),
                                each.certain());
                gaps.merge(List.of(each.certain(), each.reason(), goal), gap, Result::joined);
            }
            return List.copyOf(gaps.values());
        }

        private static Gap joined(Gap one, Gap two) {
            List<String> mistakes = new ArrayList<>(one.mistakes());
            mistakes.addAll(two.mistakes());
            return new Gap(one.transition(), mistakes, one.reason(), one.certain());
        }

        /** Holds if all is taken that can be; fails if that is nothing. */
        public Answer answer() {
            if (!uncovered.stream().allMatch(Uncovered::certain)) {
                return Answer.UNKNOWN;
            }
            return uncovered.size() == transitions ? Answer.FAILS : Answer.HOLDS;
        }
    }

    private final Promise promise;
    private final String suite;
    private final Budget budget;
    private final CoverageSearch search;
    private final Set<Goal> open;
    private final Set<String> names = new LinkedHashSet<>();

    private TransitionTests(Promise promise, String suite, Budget budget) {
        this.promise = promise;
        this.suite = suite;
        this.budget = budget;
        this.search = CoverageSearch.of(promise, budget);
        this.open = new LinkedHashSet<>(search.reached());
    }

    /**
     * @param promise an atomic component, or some of its automata: then the transitions of these
     * @param suite name of the suite
     * @throws arcomat.rt.ModelError where the component goes wrong before it reads anything
     */
    public static Result of(Promise promise, String suite, Budget budget) {
        return new TransitionTests(promise, suite, budget).run();
    }

    private Result run() {
        List<Test> tests = new ArrayList<>();
        String spent = Budget.within(() -> cover(tests), reason -> reason);
        Set<Goal> covered =
                tests.stream().flatMap(each -> each.covers().stream()).collect(Collectors.toSet());
        List<Uncovered> uncovered = new ArrayList<>();
        for (Goal goal : search.goals()) {
            if (!search.reached().contains(goal)) {
                uncovered.add(search.whyNot(goal));
            } else if (!covered.contains(goal)) { // perhaps by a test that was never finished
                uncovered.add(new Uncovered(goal, spent, false));
            }
        }
        return new Result(
                tests,
                search.goals().size(),
                uncovered,
                spent.isEmpty() ? tell(tests) : List.of(),
                search.stopped(),
                search.graph().size());
    }

    /**
     * Adds tests that tell small mistakes, slice by slice: an event-driven test looks at whole
     * streams, in which many a mistake does not show.
     */
    private List<Untold> tell(List<Test> tests) {
        boolean timed = promise.component().profile() == Component.Profile.TIME_SYNCHRONOUS;
        return timed ? new MutationTests(promise, budget).tell(tests, this::telling) : List.of();
    }

    private Test telling(DistinguishingSearch.Run run) {
        Goal transition = run.mistake().transition();
        StreamTest streams = streamTest(nameOf(transition), run.inputs(), run.expected());
        return new Test(streams, List.of(), Optional.of(run.mistake()), run.promised());
    }

    /** Empty where nothing stays open that can be taken. */
    private String cover(List<Test> tests) {
        while (!open.isEmpty()) {
            budget.insist();
            tests.add(test());
        }
        return "";
    }

    private Test test() {
        List<Goal> covers = new ArrayList<>();
        List<Step> word = new ArrayList<>();
        List<Step> anew = fromTheBeginning();
        Node start = anew.get(0).from();
        List<Step> next = anew;
        while (!next.isEmpty()) {
            take(next, word, covers);
            anew = fromTheBeginning();
            Node end = word.get(word.size() - 1).to();
            next = search.graph().path(List.of(end), open, anew.size());
        }
        StreamTest streams = streams(nameOf(covers.get(0)), beginning(start), word);
        return new Test(streams, covers, Optional.empty(), true);
    }

    /** And goes on until it would be noticed if what is new had been missing. */
    private void take(List<Step> steps, List<Step> word, List<Goal> covers) {
        List<Goal> fresh = new ArrayList<>();
        for (Step step : steps) {
            word.add(step);
            step.taken().stream().filter(open::remove).forEach(fresh::add);
        }
        covers.addAll(fresh);
        for (Goal goal : fresh) {
            List<Step> more = search.graph().without(goal).noticed(word);
            if (!more.isEmpty()) {
                take(more, word, covers);
            }
        }
    }

    /** A shortest word to a transition that is still open; empty where none is. */
    private List<Step> fromTheBeginning() {
        List<Node> starts = search.beginnings().stream().map(Beginning::node).toList();
        return open.isEmpty() ? List.of() : search.graph().path(starts, open, Integer.MAX_VALUE);
    }

    private Beginning beginning(Node start) {
        return search.beginnings().stream()
                .filter(each -> each.node() == start)
                .findFirst()
                .orElseThrow();
    }

    /** After the first transition that is new in it. */
    private String nameOf(Goal goal) {
        String name = goal.source() + "To" + capitalised(goal.target());
        String unique = name;
        for (int i = 2; !names.add(unique); i++) {
            unique = name + i;
        }
        return unique;
    }

    private static String capitalised(String word) {
        return word.substring(0, 1).toUpperCase(java.util.Locale.ROOT) + word.substring(1);
    }

    private StreamTest streams(String name, Beginning start, List<Step> word) {
        Component component = promise.component();
        boolean timed = component.profile() == Component.Profile.TIME_SYNCHRONOUS;
        List<Letter> inputs = word.stream().map(Step::letter).toList();
        Map<String, List<List<Value>>> expected = new LinkedHashMap<>();
        for (Port port : component.outputs()) {
            List<List<Value>> stream = new ArrayList<>();
            if (!timed || port.delay() > 0) {
                stream.add(start.sent().messages(port.name()));
            }
            word.forEach(step -> stream.add(step.sent().messages(port.name())));
            expected.put(port.name(), timed ? stream : List.of(joined(stream)));
        }
        return streamTest(name, inputs, expected);
    }

    private StreamTest streamTest(
            String name, List<Letter> inputs, Map<String, List<List<Value>>> expected) {
        Component component = promise.component();
        return new StreamTest(
                suite, name, component, promise.arguments(), inputs, expected, component.span());
    }

    private static List<Value> joined(List<List<Value>> stream) {
        return stream.stream().flatMap(List::stream).toList();
    }
}
