package arcomat.laws;

import arcomat.analysis.refinement.CounterexampleRun;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Moment;
import arcomat.laws.draw.Draw;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTests;
import arcomat.simulate.watch.Watch.Violation;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * Where it fails, the left side can do the counterexample, and test and monitor of the right one
 * say no.
 */
final class CounterexamplesAreForbidden implements Law {

    @Override
    public String name() {
        return "1 counterexamples are forbidden";
    }

    @Override
    public List<SourceFile> draw(Draw draw) {
        return Pairs.draw(draw);
    }

    @Override
    public Outcome check(Models models) {
        Component left = models.component(Pairs.LEFT);
        Component right = models.component(Pairs.RIGHT);
        boolean timed = left.profile() == Component.Profile.TIME_SYNCHRONOUS;
        Verdict verdict = Questions.refines(left, right);
        if (!Questions.fails(verdict) || verdict.trace().isEmpty()) {
            return Outcome.SKIPPED;
        }
        if (!timed) {
            return events(left, right, verdict.trace());
        }
        int moments = verdict.trace().size();
        if (!isSeen(left, moments) || !isSeen(right, moments)) {
            return Outcome.SKIPPED;
        }
        List<Moment> trace = verdict.trace();
        boolean error = trace.get(trace.size() - 1).error();
        List<Moment> shown = error ? trace.subList(0, trace.size() - 1) : trace;
        String refines = Questions.command(Pairs.LEFT, Pairs.RIGHT) + ": fails";
        StreamTest own = test(left, left, right, shown);
        if (StreamTests.run(own).verdict() == StreamTestResult.Verdict.FAILED) {
            return broken("the left side cannot do the counterexample", refines, own);
        }
        StreamTest other = test(right, left, right, shown);
        boolean rejected = StreamTests.run(other).verdict() == StreamTestResult.Verdict.FAILED;
        if (rejected == error && (!error || Questions.begins(right))) {
            String says = error ? "too early" : "not at all";
            return broken("test rejects the counterexample " + says, refines, other);
        }
        StreamTest before = test(right, left, right, trace.subList(0, trace.size() - 1));
        boolean early = StreamTests.run(before).verdict() == StreamTestResult.Verdict.FAILED;
        if (early && trace.size() > 1 && Questions.begins(right)) {
            return broken("test rejects the counterexample too early", refines, before);
        }
        return error || right.isComposite()
                ? Outcome.KEPT
                : watched(right, other).map(p -> broken(p, refines, other)).orElse(Outcome.KEPT);
    }

    /** A test of events does not say what follows from which; the monitor sees it. */
    private static Outcome events(Component left, Component right, List<Moment> moments) {
        Trace run = CounterexampleRun.of(left, right, moments);
        String refines = Questions.command(Pairs.LEFT, Pairs.RIGHT) + ": fails";
        StreamTest own = Recorded.test(left, right.outputs(), run);
        boolean shown = moments.size() > 1 && !run.steps().isEmpty();
        if (shown && StreamTests.run(own).verdict() == StreamTestResult.Verdict.FAILED) {
            return broken("the left side cannot do the counterexample", refines, own);
        }
        if (right.isComposite()) {
            return Outcome.KEPT;
        }
        int last = run.end().isPresent() ? run.steps().size() : Math.max(0, moments.size() - 2);
        OptionalInt violated = violated(right, left, run);
        boolean there = violated.isPresent() && violated.getAsInt() == last;
        return there
                ? Outcome.KEPT
                : broken("the monitor rejects it " + violated + ", not " + last, refines, own);
    }

    private static OptionalInt violated(Component right, Component running, Trace run) {
        return Questions.watched(right, running, run).stream()
                .flatMap(each -> each.violation().stream())
                .mapToInt(Violation::slice)
                .min();
    }

    /** What is seen last is seen in the slice of the last input, or in the one after it. */
    private static Optional<String> watched(Component right, StreamTest test) {
        List<Letter> letters = new ArrayList<>(test.inputs());
        letters.add(quietAfter(letters, right));
        List<Trace.Step> steps = new ArrayList<>();
        for (Letter letter : letters) {
            Letter shown = shown(test, steps.size());
            steps.add(new Trace.Step(steps.size(), letter, shown, List.of()));
        }
        OptionalInt violated = violated(right, right, new Trace(right, steps, Optional.empty()));
        if (violated.isEmpty()) {
            return Optional.of("the monitor rejects the counterexample not at all");
        }
        return violated.getAsInt() < letters.size() - 2
                ? Optional.of("the monitor rejects the counterexample too early")
                : Optional.empty();
    }

    /** A total port has a message even where none has gone before. */
    private static Letter quietAfter(List<Letter> letters, Component right) {
        Letter quiet = StreamTests.quietAfter(letters, Network.of(right, List.of()));
        Map<String, List<Value>> messages = new LinkedHashMap<>(quiet.messages());
        right.inputs().stream()
                .filter(Port::total)
                .forEach(p -> messages.putIfAbsent(p.name(), List.of(p.type().first())));
        return new Letter(messages);
    }

    private static Letter shown(StreamTest test, int slice) {
        Map<String, List<Value>> shown = new LinkedHashMap<>();
        test.expected()
                .forEach(
                        (port, stream) -> {
                            if (slice < stream.size()) {
                                shown.put(port, stream.get(slice));
                            }
                        });
        return new Letter(shown);
    }

    /**
     * Before the first input a test sees late outputs only; a port that nobody feeds is neither.
     */
    private static boolean isSeen(Component component, int moments) {
        Network network = Network.of(component, List.of());
        return network.outputs().stream().allMatch(e -> e.signal() >= 0)
                && (moments > 1
                        || network.outputs().stream()
                                .anyMatch(e -> network.delayed().contains(e.signal())));
    }

    private static boolean isLate(Component component, String port) {
        Network network = Network.of(component, List.of());
        return network.outputs().stream()
                .filter(e -> e.name().equals(port))
                .allMatch(e -> network.delayed().contains(e.signal()));
    }

    private static Outcome broken(String problem, String refines, StreamTest test) {
        String path = Recorded.path(test.component());
        return Outcome.broken(problem, refines, "test " + path).with(path, Recorded.text(test));
    }

    /**
     * What the moments show, slice by slice, on the ports of the right side: a reaction is seen in
     * the next slice where both sides send with delay, and else stands where it is seen. What is
     * left open is silent, or the first value.
     */
    private static StreamTest test(
            Component tested, Component left, Component right, List<Moment> moments) {
        List<Letter> inputs = new ArrayList<>();
        moments.stream().skip(1).forEach(m -> inputs.add(Recorded.own(tested, m.input())));
        Map<String, List<List<Value>>> expected = new LinkedHashMap<>();
        for (Port output : right.outputs()) {
            boolean late = isLate(left, output.name()) && isLate(right, output.name());
            List<List<Value>> stream = new ArrayList<>();
            moments.stream()
                    .skip(late ? 0 : 1)
                    .forEach(moment -> stream.add(messages(moment, output)));
            expected.put(output.name(), stream);
        }
        return new StreamTest(
                "Run", "recorded", tested, List.of(), inputs, expected, tested.span());
    }

    private static List<Value> messages(Moment moment, Port port) {
        Sent sent = moment.outputs().getOrDefault(port.name(), Sent.SILENCE);
        if (sent instanceof Sent.Messages messages) {
            return messages.values();
        }
        return sent instanceof Sent.AnyMessage ? List.of(port.type().first()) : List.of();
    }
}
