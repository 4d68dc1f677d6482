package arcomat.analysis.mona;

import arcomat.analysis.mona.Bits.Choice;
import arcomat.analysis.mona.Bits.Cube;
import arcomat.analysis.mona.Bits.Literal;
import arcomat.analysis.mona.Formula.MachineText;
import arcomat.analysis.mona.Formula.StateText;
import arcomat.analysis.mona.Formula.StepText;
import arcomat.analysis.mona.Formula.TrackText;
import arcomat.analysis.mona.Machine.State;
import arcomat.analysis.mona.Machine.Step;
import arcomat.model.Trace;
import arcomat.semantics.Output;
import arcomat.semantics.Sent;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/** Says with bits at positions what the machines of a question do. */
final class FormulaWriter {
    /**
     * The positions at which a run ends with an error; no port's bit has a name without a digit.
     */
    static final String FAILS = "fails";

    private static final String NOW = "t";
    private static final String NEXT = "t+1";
    private static final String START = "0";

    private final Question question;

    FormulaWriter(Question question) {
        this.question = question;
    }

    Formula formula() {
        List<TrackText> tracks = new ArrayList<>();
        List<Choice> valid = new ArrayList<>();
        for (Track track : question.tracks()) {
            tracks.add(new TrackText(track.legend(), track.bits().names()));
            valid.addAll(track.bits().isAtMost(track.messages().size(), NOW));
            if (track.total()) {
                valid.add(new Choice(true, List.of(track.bits().is(0, NOW))));
            }
        }
        List<MachineText> rights = new ArrayList<>();
        for (int i = 0; i < question.rights().size(); i++) {
            String name = question.rights().size() == 1 ? "right" : "right" + (i + 1);
            rights.add(
                    machine(question.rights().get(i), name, question.rightTitles().get(i), true));
        }
        return new Formula(
                question.leftTitle(),
                question.rightTitle(),
                tracks,
                valid,
                question.fails(),
                machine(question.left(), "left", question.leftTitle(), false),
                rights);
    }

    private MachineText machine(Machine machine, String name, String title, boolean right) {
        Bits bits = Question.stateBits(name, machine);
        List<StepText> openings = new ArrayList<>();
        for (Step opening : machine.openings()) {
            List<Choice> conditions = new ArrayList<>(sent(opening.sent(), START, ""));
            conditions.addAll(failing(START, false));
            conditions.add(Choice.of(bits.is(opening.next(), START)));
            openings.add(new StepText("", conditions));
        }
        List<StateText> states = new ArrayList<>();
        for (int number = 0; number < machine.states().size(); number++) {
            State state = machine.states().get(number);
            List<StepText> steps = new ArrayList<>();
            Set<List<Choice>> known = new HashSet<>();
            for (Step step : transitionsFirst(state.steps())) {
                StepText text = step(step, machine, bits, right && state.chaos());
                if (known.add(text.conditions())) {
                    steps.add(text);
                }
            }
            states.add(new StateText(state.name(), bits.is(number, NOW), steps));
        }
        return new MachineText(name, title, bits.names(), openings, states);
    }

    private static List<Step> transitionsFirst(List<Step> steps) {
        return steps.stream().sorted(Comparator.comparing(FormulaWriter::isCompletion)).toList();
    }

    private static boolean isCompletion(Step step) {
        return step.causes().stream().anyMatch(Trace.Completed.class::isInstance);
    }

    private StepText step(Step step, Machine machine, Bits bits, boolean anything) {
        List<Choice> conditions = new ArrayList<>();
        for (int i = 0; i < step.inputs().size(); i++) {
            Track track = machine.inputs().get(i);
            conditions.add(track.bits().isIn(step.inputs().get(i), track.codes(), NOW));
        }
        if (!step.error()) {
            conditions.addAll(sent(step.sent(), NEXT, NOW));
        }
        if (!anything) {
            conditions.addAll(failing(NEXT, step.error()));
        }
        conditions.add(Choice.of(bits.is(step.next(), NEXT)));
        conditions.removeIf(Choice::isTrue);
        return new StepText(origin(step), conditions);
    }

    /**
     * @param delayed where the reaction of a port with delay 1 is seen
     * @param instant where that of a port with delay 0 is; empty at the start, when there is none
     */
    private List<Choice> sent(Output output, String delayed, String instant) {
        List<Choice> conditions = new ArrayList<>();
        for (int i = 0; i < question.observed().size(); i++) {
            Track track = question.observed().get(i);
            String position = track.port().delay() == 1 ? delayed : instant;
            Sent sent = output.ports().get(i);
            if (position.isEmpty() || sent instanceof Sent.Anything) {
                continue;
            }
            Cube code = track.bits().is(track.codeOf(sent), position);
            conditions.add(new Choice(sent instanceof Sent.AnyMessage, List.of(code)));
        }
        return conditions;
    }

    private List<Choice> failing(String position, boolean fails) {
        return question.fails()
                ? List.of(Choice.of(new Cube(List.of(new Literal(FAILS, position, fails)))))
                : List.of();
    }

    private static String origin(Step step) {
        List<String> causes = step.causes().stream().flatMap(FormulaWriter::cause).toList();
        return causes.isEmpty() && step.error() ? "a model error" : String.join("; ", causes);
    }

    private static Stream<String> cause(Trace.Cause cause) {
        if (cause instanceof Trace.Completed completed) {
            String name = completed.completion().name().toLowerCase(java.util.Locale.ROOT);
            return Stream.of("otherwise: " + name);
        }
        String text = ((Trace.Taken) cause).transition().span().text();
        return Stream.of(text.replaceAll("\\s+", " ").strip()).filter(line -> !line.isEmpty());
    }
}
