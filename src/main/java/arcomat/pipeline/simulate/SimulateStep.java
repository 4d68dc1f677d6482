package arcomat.pipeline.simulate;

import arcomat.generate.plan.Choosing;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Model;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.pipeline.compile.CompiledExecution;
import arcomat.pipeline.compile.CompiledModel;
import arcomat.pipeline.compile.TooLargeToCompile;
import arcomat.pipeline.monitor.Watches;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;
import arcomat.report.run.TraceColumns;
import arcomat.rt.ModelError;
import arcomat.semantics.Execution;
import arcomat.semantics.network.Network;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.Simulation;
import arcomat.simulate.test.StreamTests;
import arcomat.simulate.watch.Watching;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.ComponentSymbol;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;

/** Runs a component over the input of a test, or over random letters. */
public final class SimulateStep {
    private static final int DEFAULT_STEPS = 20;

    /** Of a message on a port in a slice, in percent: as often silent as not. */
    private static final int CHANCE_OF_A_MESSAGE = 50;

    private final SimulationRequest request;
    private final PathNames names;
    private final Dialogue dialogue;
    private final Audience audience;

    private SimulateStep(
            SimulationRequest request, PathNames names, Dialogue dialogue, Audience audience) {
        this.request = request;
        this.names = names;
        this.dialogue = dialogue;
        this.audience = audience;
    }

    /** Runs it for who takes the whole run. */
    public static SimulationResult run(
            SimulationRequest request,
            List<String> paths,
            Dialogue dialogue,
            PathNames names,
            Progress progress)
            throws WrongUse {
        return run(request, paths, dialogue, Audience.NOBODY, names, progress);
    }

    /** Runs it before an audience. */
    public static SimulationResult run(
            SimulationRequest request,
            List<String> paths,
            Dialogue dialogue,
            Audience audience,
            PathNames names,
            Progress progress)
            throws WrongUse {
        if (request.record().isPresent()) {
            Recorder.requireWritable(request, names);
        }
        Optional<TestReference> input = Optional.empty();
        List<String> all = new ArrayList<>(paths);
        if (request.input().isPresent()) {
            input = Optional.of(TestReference.parse(request.input().get()));
            all.add(input.get().file());
        }
        boolean compiled = request.engine() == SimulationRequest.Engine.COMPILED;
        Optional<TestReference> test = input;
        CheckedModels checked =
                CheckedModels.checkToRun(
                        all,
                        asked(request, test, names),
                        models -> compiled ? mayRun(request, test, models, names) : List.of(),
                        names,
                        progress);
        if (checked.hasErrors()) {
            return new SimulationResult(checked.result(), Optional.empty(), List.of());
        }
        Model model = checked.lower(progress);
        progress.step("simulating");
        SimulateStep step = new SimulateStep(request, names, dialogue, audience);
        MainComponent main = step.main(checked, model, step.test(model, input));
        Watching watching =
                new Watching(Watches.of(request.monitors(), main.component(), checked, model));
        Trace trace = step.run(main, step.test(model, input), watching);
        return new SimulationResult(checked.result(), Optional.of(trace), watching.end(trace));
    }

    /** What runs, and what watches it; everything where neither says what runs. */
    private static Asked asked(
            SimulationRequest request, Optional<TestReference> input, PathNames names) {
        if (request.main().isEmpty() && input.isEmpty()) {
            return Asked.EVERYTHING;
        }
        List<String> named = new ArrayList<>(request.monitors());
        request.main().ifPresent(named::add);
        return models ->
                (named.isEmpty() || Asked.components(named).isIn(models))
                        && input.stream()
                                .noneMatch(test -> test.components(models, names).isEmpty());
    }

    /** The component that code is made of, before it is sure that there is exactly one. */
    private static List<ComponentSymbol> mayRun(
            SimulationRequest request,
            Optional<TestReference> input,
            Workspace models,
            PathNames names) {
        if (request.main().isPresent()) {
            return MainComponent.symbols(request.main().get(), models);
        }
        if (input.isPresent()) {
            return input.get().components(models, names);
        }
        return models.components().stream().filter(each -> each.signature().isDeploy()).toList();
    }

    private Optional<StreamTest> test(Model model, Optional<TestReference> input) throws WrongUse {
        return input.isPresent() ? Optional.of(input.get().in(model, names)) : Optional.empty();
    }

    private Trace run(MainComponent main, Optional<StreamTest> test, Watching watching)
            throws WrongUse {
        Network network;
        try {
            network = Network.of(main.component(), main.arguments());
        } catch (ModelError error) {
            Trace nothing = new Trace(main.component(), List.of(), Optional.of(error.getMessage()));
            audience.text().begin(main.component(), TraceColumns.of(main.component()));
            audience.text().end(0, nothing);
            return record(main, nothing, List.of());
        }
        boolean compiled = request.engine() == SimulationRequest.Engine.COMPILED;
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
                            if (keepsSteps()) {
                                kept.add(step);
                            }
                            shown.incrementAndGet();
                            audience.text().step(step);
                            return audience.staysAfter(step.number());
                        });
        audience.text().end(shown.get(), rest);
        return record(main, rest.with(kept), interpreter.decisions());
    }

    /** Only for whom the whole run is needed at once. */
    private boolean keepsSteps() {
        return audience == Audience.NOBODY || request.keepsSteps();
    }

    private Interpreter interpreter(MainComponent main) {
        return request.record().isPresent()
                ? new Interpreter(main.component(), main.arguments(), choice())
                : Interpreter.forgetful(main.component(), main.arguments(), choice());
    }

    private Trace record(MainComponent main, Trace trace, List<String> decisions) throws WrongUse {
        if (request.record().isPresent()) {
            Recorder.write(request, main, trace, decisions, names);
        }
        return trace;
    }

    private Execution compiled(MainComponent main) throws WrongUse {
        Choosing choosing =
                switch (request.choosing()) {
                    case FIRST -> Choosing.FIRST;
                    case RANDOM -> Choosing.RANDOM;
                    case ASK ->
                            throw new WrongUse(
                                    "compiled code cannot ask; use --engine interpreter");
                };
        try {
            CompiledModel model = CompiledModel.of(main.component(), choosing);
            return new CompiledExecution(model, main.arguments(), request.seed());
        } catch (TooLargeToCompile e) {
            throw new WrongUse(e.getMessage() + ", or use --engine interpreter");
        }
    }

    /** Tells the dialogue of every step, so that it can make sense of questions. */
    private Execution watched(Execution execution) {
        return new Execution() {
            private int number;

            @Override
            public Component component() {
                return execution.component();
            }

            @Override
            public Trace.Step step(Letter input) {
                dialogue.stepBegins(number++, input);
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

    private MainComponent main(CheckedModels checked, Model model, Optional<StreamTest> test)
            throws WrongUse {
        if (request.main().isEmpty()) {
            return test.isPresent()
                    ? new MainComponent(test.get().component(), test.get().arguments())
                    : MainComponent.onlyDeployed(model);
        }
        MainComponent main = MainComponent.find(request.main().get(), checked, model);
        if (test.isPresent() && !test.get().component().equals(main.component())) {
            throw new WrongUse(
                    "'"
                            + test.get().suite()
                            + "' tests "
                            + test.get().component().qualifiedName()
                            + ", not "
                            + main.component().qualifiedName());
        }
        return main;
    }

    private Choice choice() {
        return switch (request.choosing()) {
            case FIRST -> Choice.first();
            case RANDOM -> Choice.random(request.seed());
            case ASK -> Choice.ask(dialogue);
        };
    }

    /** The letters of the test, or random ones; behind the input it is quiet. */
    private Iterator<Letter> letters(Network network, Optional<StreamTest> test) {
        if (test.isEmpty()) {
            int count = request.slices().orElse(DEFAULT_STEPS);
            return Simulation.drawn(network, request.seed(), CHANCE_OF_A_MESSAGE)
                    .limit(count)
                    .iterator();
        }
        List<Letter> given = test.get().inputs();
        int count = request.slices().orElse(length(test.get()));
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
