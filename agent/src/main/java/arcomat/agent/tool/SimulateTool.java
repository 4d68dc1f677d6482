package arcomat.agent.tool;

import arcomat.pipeline.Progress;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.pipeline.simulate.Decider;
import arcomat.pipeline.simulate.SimulateComponent;
import arcomat.pipeline.simulate.SimulateComponent.Audience;
import arcomat.pipeline.simulate.SimulateComponent.Run;
import arcomat.report.run.TraceJson;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/** A run of a component. */
final class SimulateTool implements Tool {
    private static final String COMPONENT = "component";
    private static final String INPUT = "input";
    private static final String SLICES = "slices";
    private static final String SEED = "seed";
    private static final String CHOOSE = "choose";
    private static final String WHY_NOT = "whyNot";
    private static final List<String> RULES = List.of("first", "random");
    private static final int MOST_SLICES = 1_000_000;

    /** Characters; nobody reads as much, and it has to be kept in memory. */
    private static final int LONGEST = 20_000_000;

    @Override
    public String name() {
        return "simulate";
    }

    @Override
    public String description() {
        return "Runs a component over the input of a stream test, or over random input from a"
                + " seed, and tells for each slice what went in, what came out, and by which"
                + " transition of which automaton.";
    }

    @Override
    public List<ToolParameter> parameters() {
        return List.of(
                ToolParameter.text(
                        COMPONENT,
                        "What to run, with arguments if it takes some: p.Timer(2). May be absent"
                                + " with 'input', or where one component alone is <<deploy>>."),
                ToolParameter.text(INPUT, "Take the input of a stream test: FILE.mt#test."),
                ToolParameter.number(
                        SLICES,
                        0,
                        MOST_SLICES,
                        "How many slices; default: those of 'input', else 20."),
                ToolParameter.number(
                        SEED, Integer.MIN_VALUE, Integer.MAX_VALUE, "Of what is drawn; default 1."),
                ToolParameter.choice(
                        CHOOSE, RULES, "Who decides where a model leaves it open; default first."),
                ToolParameter.flag(
                        WHY_NOT,
                        "Also tell which transition came nearest where none fired, and what it"
                                + " would have needed."),
                ToolParameter.paths());
    }

    @Override
    public ToolAnswer answer(ToolCall call) throws WrongUse {
        StringBuilder text = new StringBuilder();
        CheckedAnswer<Run> reply = call.session().run(task(call, text));
        call.session().progress().goOn();
        if (text.length() >= LONGEST) {
            throw new WrongUse(
                    "the run has more than %d characters; ask for fewer slices", LONGEST);
        }
        return ToolAnswer.of(reply, run -> text.toString());
    }

    private static SimulateComponent task(ToolCall call, StringBuilder text) throws WrongUse {
        ToolArguments told = call.arguments();
        Optional<Long> slices = told.number(SLICES, 0, MOST_SLICES);
        boolean whyNot = told.flag(WHY_NOT);
        return new SimulateComponent(
                told.text(COMPONENT),
                slices.isPresent() ? OptionalInt.of(slices.get().intValue()) : OptionalInt.empty(),
                told.number(SEED, Integer.MIN_VALUE, Integer.MAX_VALUE).orElse(1L).intValue(),
                told.choice(CHOOSE, RULES).equals("first")
                        ? Decider.Rule.FIRST
                        : Decider.Rule.RANDOM,
                false,
                told.text(INPUT),
                Optional.empty(),
                List.of(),
                false,
                whyNot,
                audience(text, whyNot, call.session().progress()),
                told.text(INPUT).isPresent() ? told.texts(ToolParameter.PATHS) : call.paths());
    }

    /** Goes when it has heard enough, or when the time is up. */
    private static Audience audience(StringBuilder text, boolean whyNot, Progress progress) {
        return new Audience(
                new TraceJson(text::append, whyNot),
                () -> {
                    progress.goOn();
                    return text.length() < LONGEST;
                });
    }
}
