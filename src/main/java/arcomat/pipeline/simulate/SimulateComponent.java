package arcomat.pipeline.simulate;

import arcomat.generate.plan.Choosing;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.LoadedModels;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.pipeline.compile.CompiledExecution;
import arcomat.pipeline.compile.CompiledModel;
import arcomat.pipeline.compile.CompiledModel.TooLargeToCompile;
import arcomat.pipeline.generate.Watches;
import arcomat.report.run.RunText;
import arcomat.report.run.TraceColumns;
import arcomat.rt.ModelError;
import arcomat.semantics.Execution;
import arcomat.semantics.network.Network;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.Simulation;
import arcomat.simulate.test.StreamTests;
import arcomat.simulate.watch.Watching;
import arcomat.simulate.watch.Watching.Watched;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;

/**
 * Runs a component over the input of a test, or over random letters.
 *
 * @param main the component, {@code p.Timer(2)} with its arguments; empty if the input or the
 *     models leave only one
 * @param slices how many steps to run; empty for the length of the input
 * @param seed of whatever is drawn: choices, and letters where there is no input
 * @param decider who decides where a model leaves something open
 * @param compiled whether compiled code runs, and not the interpreter
 * @param input {@code FILE.mt#test}, whose input streams are used
 * @param record a file that keeps the run as a stream test
 * @param monitors what watches the run: components, or {@code component#automaton}
 * @param whole whether the result holds all steps; else they would only fill the memory
 * @param explaining whether the run tells why no transition fired; only the interpreter can
 * @param audience looks on
 */
public record SimulateComponent(
        Optional<String> main,
        OptionalInt slices,
        int seed,
        Decider decider,
        boolean compiled,
        Optional<String> input,
        Optional<String> record,
        List<String> monitors,
        boolean whole,
        boolean explaining,
        Audience audience,
        List<String> paths)
        implements Task<CheckedAnswer<SimulateComponent.Run>> {
    private static final int DEFAULT_STEPS = 20;

    /** Of a message on a port in a slice, in percent: as often silent as not. */
    private static final int CHANCE_OF_A_MESSAGE = 50;

    /**
     * Who looks at a run while it goes on.
     *
     * @param text is told of every step
     * @param present whether anybody still reads it
     */
    public record Audience(RunText text, BooleanSupplier present) {
        /** As often the audience is asked whether it is still there. */
        private static final int STEPS_BETWEEN = 256;

        boolean staysAfter(int step) {
            return step % STEPS_BETWEEN != 0 || present.getAsBoolean();
        }
    }

    /**
     * What came of a simulation.
     *
     * @param watched what became of the requirements that the run was watched for
     */
    public record Run(Trace trace, List<Watched> watched) {}

    /**
     * @throws WrongUse where this does not fit the models, or the run cannot be recorded
     */
    @Override
    public CheckedAnswer<Run> run(Session session) throws WrongUse {
        Optional<RunRecorder> recorder = Optional.empty();
        if (record.isPresent()) {
            recorder = Optional.of(RunRecorder.of(record.get(), session.names()));
        }
        Optional<TestReference> test = Optional.empty();
        List<String> all = new ArrayList<>(paths);
        if (input.isPresent()) {
            test = Optional.of(TestReference.parse(input.get(), session.names()));
            all.add(test.get().file());
        }
        Optional<TestReference> given = test;
        CheckedModels checked =
                CheckedModels.checkToRun(
                        all,
                        asked(given),
                        (models, loaded) -> compiled ? mayRun(given, models, loaded) : List.of(),
                        session);
        if (checked.hasErrors()) {
            return CheckedAnswer.refused(checked.result());
        }
        LoweredModels models = checked.lower(session);
        session.progress().step("simulating");
        Optional<StreamTest> letters = Optional.empty();
        if (test.isPresent()) {
            letters = Optional.of(test.get().in(models.model()));
        }
        MainComponent component = main(models, letters);
        Watching watching = new Watching(Watches.of(monitors, component.component(), models));
        Trace trace = run(component, letters, watching, recorder);
        return CheckedAnswer.of(checked.result(), new Run(trace, watching.end(trace)));
    }

    /** What runs, and what watches it; everything where neither says what runs. */
    private Asked asked(Optional<TestReference> test) {
        if (main.isEmpty() && test.isEmpty()) {
            return Asked.EVERYTHING;
        }
        List<String> named = new ArrayList<>(monitors);
        main.ifPresent(named::add);
        return models ->
                (named.isEmpty() || Asked.components(named).isIn(models))
                        && test.stream().noneMatch(each -> each.components(models).isEmpty());
    }

    /** The component that code is made of, before it is sure that there is exactly one. */
    private List<ComponentSymbol> mayRun(
            Optional<TestReference> test, Workspace models, LoadedModels loaded) {
        if (main.isPresent()) {
            return MainComponent.symbols(main.get(), models);
        }
        if (test.isPresent()) {
            return test.get().components(models);
        }
        return models.components().stream()
                .filter(each -> each.signature().isDeploy())
                .filter(each -> !loaded.isOfLibrary(each.node().span().file().path()))
                .toList();
    }

    private Trace run(
            MainComponent main,
            Optional<StreamTest> test,
            Watching watching,
            Optional<RunRecorder> recorder)
            throws WrongUse {
        Network network;
        try {
            network = Network.of(main.component(), main.arguments());
        } catch (ModelError error) {
            String reason = String.valueOf(error.getMessage());
            Trace nothing = new Trace(main.component(), List.of(), Optional.of(reason));
            audience.text().begin(main.component(), TraceColumns.of(main.component()));
            audience.text().end(0, nothing);
            return record(recorder, main, nothing, List.of());
        }
        Interpreter interpreter = interpreter(main);
        Execution execution = compiled ? compiled(main) : watched(interpreter);
        List<Trace.Step> kept = new ArrayList<>();
        AtomicInteger shown = new AtomicInteger();
        audience.text().begin(main.component(), TraceColumns.of(network));
        Trace rest =
                Simulation.run(
                        execution,
                        letters(network, test),
                        step -> {
                            watching.see(execution.opening(), step);
                            if (whole || record.isPresent()) {
                                kept.add(step);
                            }
                            shown.incrementAndGet();
                            audience.text().step(step);
                            return audience.staysAfter(step.number());
                        });
        audience.text().end(shown.get(), rest);
        return record(recorder, main, rest.with(kept), interpreter.decisions());
    }

    private Interpreter interpreter(MainComponent main) {
        Choice choice = decider.choice(seed);
        Interpreter interpreter =
                record.isPresent()
                        ? new Interpreter(main.component(), main.arguments(), choice)
                        : Interpreter.forgetful(main.component(), main.arguments(), choice);
        return explaining ? interpreter.explaining() : interpreter;
    }

    private Trace record(
            Optional<RunRecorder> recorder, MainComponent main, Trace trace, List<String> decisions)
            throws WrongUse {
        if (recorder.isPresent()) {
            String how = "choices " + decider.name().toLowerCase(Locale.ROOT) + ", seed " + seed;
            recorder.get().write(how, main, trace, decisions);
        }
        return trace;
    }

    private Execution compiled(MainComponent main) throws WrongUse {
        Choosing choosing =
                decider.compiled()
                        .orElseThrow(
                                () ->
                                        new WrongUse(
                                                "compiled code cannot ask; use --engine"
                                                        + " interpreter"));
        try {
            CompiledModel model = CompiledModel.of(main.component(), choosing);
            return new CompiledExecution(model, main.arguments(), seed);
        } catch (TooLargeToCompile e) {
            throw new WrongUse(e.getMessage() + ", or use --engine interpreter");
        }
    }

    /** Who is asked is told of every step, and can make sense of questions. */
    private Execution watched(Execution execution) {
        return new Execution() {
            private int number;

            @Override
            public Component component() {
                return execution.component();
            }

            @Override
            public Trace.Step step(Letter input) {
                decider.stepBegins(number++, input);
                return execution.step(input);
            }

            @Override
            public Optional<Letter> opening() {
                return execution.opening();
            }

            @Override
            public Optional<Trace.End> end() {
                return execution.end();
            }
        };
    }

    private MainComponent main(LoweredModels models, Optional<StreamTest> test) throws WrongUse {
        if (main.isEmpty()) {
            return test.isPresent()
                    ? new MainComponent(test.get().component(), test.get().arguments())
                    : MainComponent.onlyDeployed(models);
        }
        MainComponent named = MainComponent.find(main.get(), models);
        if (test.isPresent() && !test.get().component().equals(named.component())) {
            throw new WrongUse(
                    "'%s' tests %s, not %s",
                    test.get().qualifiedSuite(),
                    test.get().component().qualifiedName(),
                    named.component().qualifiedName());
        }
        return named;
    }

    /** The letters of the test, or random ones; behind the input it is quiet. */
    private Iterator<Letter> letters(Network network, Optional<StreamTest> test) {
        if (test.isEmpty()) {
            int count = slices.orElse(DEFAULT_STEPS);
            return Simulation.drawn(network, seed, CHANCE_OF_A_MESSAGE).limit(count).iterator();
        }
        List<Letter> given = test.get().inputs();
        int count = slices.orElse(length(test.get()));
        Letter quiet = StreamTests.quietAfter(given, network);
        return Stream.concat(given.stream(), Stream.generate(() -> quiet)).limit(count).iterator();
    }

    /** Where outputs have delay 1, the reaction to the last input shows one slice later. */
    private static int length(StreamTest test) {
        Component component = test.component();
        boolean delayed =
                component.profile() == Component.Profile.TIME_SYNCHRONOUS
                        && component.outputs().stream().anyMatch(port -> port.delay() > 0);
        return test.inputs().size() + (delayed ? 1 : 0);
    }
}
