package arcomat.analysis.mona;

import arcomat.analysis.mona.Bits.Condition;
import arcomat.analysis.mona.Bits.Cube;
import arcomat.analysis.mona.Bits.Literal;
import arcomat.analysis.mona.ExplicitSystem.State;
import arcomat.analysis.mona.ExplicitSystem.Step;
import arcomat.analysis.mona.MonaFormula.StateText;
import arcomat.analysis.mona.MonaFormula.StepText;
import arcomat.analysis.mona.MonaFormula.SystemText;
import arcomat.model.Trace;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.Stream;

/** Says with bits at positions what one system does. */
final class SystemWriter {
    /**
     * The positions at which a run ends with an error; no port's bit has a name without a digit.
     */
    static final String FAILS = "fails";

    static final String NOW = "t";
    private static final String NEXT = "t+1";
    private static final String START = "0";

    private final InclusionProblem question;
    private final ExplicitSystem system;
    private final String name;
    private final boolean right;
    private final boolean fails;
    private final Bits states;
    private final List<Step> openings;
    private final List<List<Step>> steps = new ArrayList<>();
    private final int picks;

    /**
     * @param name of the predicate
     * @param right whether it is on the right side, where states are hidden
     */
    SystemWriter(InclusionProblem question, ExplicitSystem system, String name, boolean right) {
        this.question = question;
        this.system = system;
        this.name = name;
        this.right = right;
        this.fails = question.fails();
        this.states = system.stateBits(name);
        this.openings = different(system.openings());
        system.states().forEach(state -> steps.add(different(inOrder(state.steps()))));
        this.picks =
                Stream.concat(Stream.of(openings), steps.stream())
                        .flatMap(each -> Alternatives.number(each).stream())
                        .max(Comparator.naturalOrder())
                        .map(most -> most + 1)
                        .orElse(1);
    }

    /** In text order, completions last. */
    private static List<Step> inOrder(List<Step> steps) {
        return steps.stream()
                .sorted(Comparator.comparing(SystemWriter::places, Arrays::compare))
                .toList();
    }

    private static int[] places(Step step) {
        return step.causes().stream()
                .mapToInt(c -> c instanceof Trace.Taken taken ? taken.index() : Integer.MAX_VALUE)
                .toArray();
    }

    /** Steps that read, send and reach the same are one. */
    private static List<Step> different(List<Step> steps) {
        Map<List<Object>, Step> different = new LinkedHashMap<>();
        for (Step step : steps) {
            different.putIfAbsent(
                    Arrays.asList(step.inputs(), step.error(), step.sent(), step.next()), step);
        }
        return List.copyOf(different.values());
    }

    SystemText text() {
        List<Integer> numbers = Alternatives.number(openings);
        List<StepText> begin = new ArrayList<>();
        for (int i = 0; i < openings.size(); i++) {
            begin.add(opening(openings.get(i), numbers.get(i)));
        }
        List<StateText> all = new ArrayList<>();
        for (int number = 0; number < steps.size(); number++) {
            all.add(state(number));
        }
        List<String> hidden = isPicked() ? picked().names() : List.of();
        return new SystemText(name, system.title(), states.names(), hidden, begin, all);
    }

    private boolean isPicked() {
        return right && picks > 1;
    }

    private Bits picked() {
        return Bits.named(name + "Pick", picks);
    }

    private StepText opening(Step opening, int number) {
        List<Condition> conditions = new ArrayList<>(sent(opening.sent(), START, ""));
        conditions.addAll(failing(START, false));
        conditions.addAll(reached(opening, number, START));
        return new StepText("", conditions);
    }

    private StateText state(int number) {
        State state = system.states().get(number);
        List<Integer> numbers = Alternatives.number(steps.get(number));
        List<StepText> texts = new ArrayList<>();
        for (int i = 0; i < numbers.size(); i++) {
            texts.add(step(steps.get(number).get(i), numbers.get(i)));
        }
        return new StateText(state.name(), states.is(number, NOW), texts);
    }

    private StepText step(Step step, int number) {
        List<Condition> conditions = new ArrayList<>();
        for (int i = 0; i < step.inputs().size(); i++) {
            PortTrack track = system.inputs().get(i);
            conditions.add(track.bits().isIn(step.inputs().get(i), track.codes(), NOW));
        }
        conditions.addAll(step.error() ? stillSeen(step.sent()) : sent(step.sent(), NEXT, NOW));
        conditions.addAll(failing(NEXT, step.error()));
        conditions.addAll(reached(step, number, NEXT));
        conditions.removeIf(Condition::isTrue);
        return new StepText(origin(step), conditions);
    }

    /** The next state, and which of several possible steps leads there. */
    private List<Condition> reached(Step step, int number, String position) {
        Condition next = Condition.of(states.is(step.next(), position));
        return isPicked()
                ? List.of(Condition.of(picked().is(number, position)), next)
                : List.of(next);
    }

    /**
     * @param delayed where the reaction of a port with delay 1 is seen
     * @param instant where that of a port with delay 0 is; empty at the start, when there is none
     */
    private List<Condition> sent(@Nullable Output output, String delayed, String instant) {
        List<Condition> conditions = new ArrayList<>();
        for (int i = 0; i < question.observed().size(); i++) {
            String position = question.delays().get(i) == 1 ? delayed : instant;
            if (!position.isEmpty()) {
                conditions.addAll(sent(i, Objects.requireNonNull(output).ports().get(i), position));
            }
        }
        return conditions;
    }

    private List<Condition> sent(int port, Sent sent, String position) {
        if (sent instanceof Sent.Anything) {
            return List.of();
        }
        PortTrack track = question.observed().get(port);
        Cube code = track.bits().is(track.codeOf(sent), position);
        return List.of(sent instanceof Sent.AnyMessage ? Condition.not(code) : Condition.of(code));
    }

    /**
     * What is seen in the slice in which a run ends: where one of both sides sends with delay, its
     * earlier reaction, and nothing of the other's.
     *
     * @param output null for nothing
     */
    private List<Condition> stillSeen(@Nullable Output output) {
        return question.mixed().stream()
                .boxed()
                .flatMap(
                        port ->
                                sent(
                                        port,
                                        output == null ? Sent.SILENCE : output.ports().get(port),
                                        NOW)
                                        .stream())
                .toList();
    }

    private List<Condition> failing(String position, boolean now) {
        return fails
                ? List.of(Condition.of(new Cube(List.of(new Literal(FAILS, position, now)))))
                : List.of();
    }

    private static String origin(Step step) {
        List<String> causes = step.causes().stream().flatMap(SystemWriter::cause).toList();
        return causes.isEmpty() && step.error() ? "a model error" : String.join("; ", causes);
    }

    private static Stream<String> cause(Trace.Cause cause) {
        if (cause instanceof Trace.Completed completed) {
            String name = completed.completion().name().toLowerCase(java.util.Locale.ROOT);
            return Stream.of("otherwise: " + name);
        }
        String text = ((Trace.Taken) cause).transition().span().text();
        String line = text.replaceAll("\\s+", " ").replaceFirst(";? ?$", "").strip();
        return line.isEmpty() ? Stream.empty() : Stream.of(line);
    }
}
