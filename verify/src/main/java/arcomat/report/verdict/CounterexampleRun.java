package arcomat.report.verdict;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.TraceReplay;
import arcomat.analysis.search.Moment;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.report.run.TraceTracks;
import arcomat.rt.ModelError;
import arcomat.semantics.Promise;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.test.StreamTests;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * What the parts of a composition do in a counterexample. The moments say what a side shows and, in
 * words, where it is, or may be; this tries its choices one after the other until a run of the
 * interpreter shows the same. The right side is followed as far as it can do what the left one
 * does. Where no run is found nothing is told: what parts may have done is not what they did.
 */
final class CounterexampleRun {
    /** Steps of the interpreter in all tries: less than a second for forty parts. */
    private static final int MOST_STEPS = 10_000;

    /** What it costs to begin a run, in steps: then all automata are made ready. */
    private static final int BEGINNING = 50;

    private final Promise side;
    private final boolean isLeft;
    private final Network network;

    /** All that a side does: the last one shows what the right side cannot do. */
    private final List<Moment> moments;

    private final Optional<Moment> impossible;

    /** Of a refinement, by moment what is sent in reaction to its input; of an invariant, empty. */
    private final List<Map<String, Sent>> reactions;

    private final List<Letter> letters = new ArrayList<>();
    private final boolean timed;

    /** Whether the first moment has no input: it shows where the run begins. */
    private final boolean begun;

    private final Set<String> delayed = new HashSet<>();
    private int taken;

    private CounterexampleRun(Answered answered, int position) {
        side = answered.sides().get(position);
        isLeft = position == 0;
        network = side.network();
        List<Moment> trace = answered.verdict().trace();
        int last = trace.size() - 1;
        moments = isLeft ? trace : trace.subList(0, last);
        impossible = isLeft ? Optional.empty() : Optional.of(trace.get(last));
        begun = answered.question() == Answered.Question.REFINEMENT;
        reactions = begun ? TraceReplay.reactions(answered.sides(), position, moments) : List.of();
        timed = side.component().profile() == Component.Profile.TIME_SYNCHRONOUS;
        moments.stream().skip(begun ? 1 : 0).map(Moment::input).forEach(letters::add);
        learnDelays();
    }

    private void learnDelays() {
        Set<Integer> late = timed ? network.delayed() : Set.of();
        network.outputs().stream()
                .filter(each -> late.contains(each.signal()))
                .forEach(each -> delayed.add(each.name()));
        for (Network.Instance each : network.instances()) {
            for (int i = 0; i < each.outputSignals().size(); i++) {
                if (late.contains(each.outputSignals().get(i))) {
                    String port = each.component().outputs().get(i).name();
                    delayed.add(each.path() + "." + port);
                }
            }
        }
    }

    /**
     * A step for each moment. Of a refinement, each message stands where it is sent; of an
     * invariant, where it is seen, as the moments have it. Empty where the side is no composition,
     * or no run is found.
     *
     * @param position of the side: 0 for the left one
     */
    static Optional<TraceTracks> of(Answered answered, int position) {
        boolean told =
                answered.verdict().trace().size() > position
                        && answered.sides().size() > position
                        && answered.sides().get(position).isComposition();
        return told ? new CounterexampleRun(answered, position).search() : Optional.empty();
    }

    private Optional<TraceTracks> search() {
        OrderedChoices choices = new OrderedChoices();
        do {
            Optional<List<Trace.Step>> run = attempt(choices);
            if (run.isPresent()) {
                return run.map(this::tracks);
            }
        } while (taken < MOST_STEPS && choices.advance());
        return Optional.empty();
    }

    private TraceTracks tracks(List<Trace.Step> steps) {
        List<Trace.Step> all = begun ? told(steps) : steps;
        Trace trace = new Trace(side.component(), all, Optional.empty());
        return begun ? TraceTracks.begun(trace) : TraceTracks.told(trace);
    }

    /** The steps over all letters, and where time passes one more, which shows what is late. */
    private Optional<List<Trace.Step>> attempt(OrderedChoices choices) {
        choices.begin();
        taken += BEGINNING;
        Interpreter interpreter =
                new Interpreter(side.component(), side.arguments(), choices).explaining();
        List<Trace.Step> steps = new ArrayList<>();
        for (Letter letter : letters) {
            Optional<Trace.Step> step = step(interpreter, letter);
            if (step.isEmpty()) {
                return endsInError(steps) ? Optional.of(steps) : Optional.empty();
            }
            steps.add(step.get());
            if (!isMeant(steps, interpreter)) {
                return Optional.empty();
            }
        }
        if (timed && begun) {
            step(interpreter, StreamTests.quietAfter(letters, network)).ifPresent(steps::add);
        }
        return steps.size() == letters.size() || isShown(letters.size(), steps, interpreter)
                ? Optional.of(steps)
                : Optional.empty();
    }

    /** Empty where the model goes wrong. */
    private Optional<Trace.Step> step(Interpreter interpreter, Letter letter) {
        taken++;
        try {
            return Optional.of(interpreter.step(letter));
        } catch (ModelError error) {
            return Optional.empty();
        }
    }

    private boolean endsInError(List<Trace.Step> steps) {
        return moments.get(moments.size() - 1).error() && steps.size() == letters.size() - 1;
    }

    private boolean isMeant(List<Trace.Step> steps, Interpreter interpreter) {
        int last = steps.size() - 1;
        return isShown(last, steps, interpreter)
                && isThere(steps.get(last).activities(), moments.get(begun ? last + 1 : last));
    }

    /** Whether it is where the words say, or in one of the places where it may be. */
    private boolean isThere(List<Trace.Activity> activities, Moment moment) {
        List<String> places = isLeft ? List.of(moment.left()) : moment.right();
        return places.stream().anyMatch(words -> isThere(activities, words));
    }

    /** Whether what is seen in a step is what the moments say, as far as they say anything. */
    private boolean isShown(int at, List<Trace.Step> steps, Interpreter interpreter) {
        Letter outputs = steps.get(at).outputs();
        for (Network.External output : network.outputs()) {
            String port = output.name();
            boolean late = delayed.contains(port);
            if (at == letters.size() && !late) {
                continue;
            }
            List<Value> seen = outputs.messages(port);
            if (!timed && at == 0 && interpreter.opening().isPresent()) {
                seen = seen.subList(interpreter.opening().get().messages(port).size(), seen.size());
            }
            Sent sent =
                    begun
                            ? reactions.get(late ? at : at + 1).get(port)
                            : moments.get(at).outputs().get(port);
            if (sent != null && !sent.allows(seen)) {
                return false;
            }
        }
        return true;
    }

    /** Whether all parts that the words tell of are where the words say. */
    private static boolean isThere(List<Trace.Activity> activities, String words) {
        String all = ", " + words + ", ";
        Map<String, String> parts = new LinkedHashMap<>();
        for (Trace.Activity each : activities) {
            parts.merge(each.instance(), words(each), (one, other) -> one + ", " + other);
        }
        return parts.entrySet().stream()
                .filter(each -> all.contains(", " + each.getKey() + ": "))
                .allMatch(
                        each -> all.contains(", " + each.getKey() + ": " + each.getValue() + ", "));
    }

    private static String words(Trace.Activity activity) {
        List<String> variables = new ArrayList<>();
        activity.variables().forEach((name, value) -> variables.add(name + " = " + value));
        return variables.isEmpty()
                ? activity.after()
                : activity.after() + " (" + String.join(", ", variables) + ")";
    }

    /** The steps as the moments count them, with each message where it is sent. */
    private List<Trace.Step> told(List<Trace.Step> steps) {
        List<Trace.Step> told = new ArrayList<>();
        for (int moment = 0; moment < moments.size(); moment++) {
            Optional<Trace.Step> step = at(steps, moment - 1);
            told.add(
                    new Trace.Step(
                            moment,
                            moments.get(moment).input(),
                            Letter.SILENCE,
                            moment > 0
                                    ? step.map(Trace.Step::activities).orElse(List.of())
                                    : List.of(),
                            between(step, at(steps, moment))));
        }
        impossible.ifPresent(
                moment ->
                        told.add(
                                new Trace.Step(
                                        told.size(),
                                        moment.input(),
                                        Letter.SILENCE,
                                        List.of(),
                                        Letter.SILENCE)));
        return told;
    }

    private static Optional<Trace.Step> at(List<Trace.Step> steps, int index) {
        return index < 0 || index >= steps.size()
                ? Optional.empty()
                : Optional.of(steps.get(index));
    }

    /** What is sent at once, and what the next slice shows. */
    private Letter between(Optional<Trace.Step> now, Optional<Trace.Step> next) {
        Map<String, List<Value>> sent = new LinkedHashMap<>();
        now.ifPresent(
                step ->
                        step.between()
                                .messages()
                                .forEach(
                                        (port, values) -> {
                                            if (!delayed.contains(port)) {
                                                sent.put(port, values);
                                            }
                                        }));
        next.ifPresent(
                step ->
                        step.between()
                                .messages()
                                .forEach(
                                        (port, values) -> {
                                            if (delayed.contains(port)) {
                                                sent.put(port, values);
                                            }
                                        }));
        return new Letter(sent);
    }
}
