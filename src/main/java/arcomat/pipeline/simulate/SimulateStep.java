package arcomat.pipeline.simulate;

import arcomat.generate.Choosing;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Model;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.pipeline.compile.CompiledExecution;
import arcomat.pipeline.compile.CompiledModel;
import arcomat.pipeline.monitor.Watches;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;
import arcomat.rt.ModelError;
import arcomat.semantics.Execution;
import arcomat.semantics.Network;
import arcomat.simulate.Choice;
import arcomat.simulate.Interpreter;
import arcomat.simulate.Simulation;
import arcomat.simulate.StreamTests;
import arcomat.simulate.Watch;
import arcomat.simulate.Watched;
import arcomat.symbols.ComponentSymbol;
import arcomat.symbols.Workspace;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Runs a component over the input of a test, or over random letters. */
public final class SimulateStep {
    private static final int DEFAULT_STEPS = 20;

    /** Of a message on a port in a slice, in percent: as often silent as not. */
    private static final int CHANCE_OF_A_MESSAGE = 50;

    private final SimulationRequest request;
    private final PathNames names;
    private final Dialogue dialogue;

    private SimulateStep(SimulationRequest request, PathNames names, Dialogue dialogue) {
        this.request = request;
        this.names = names;
        this.dialogue = dialogue;
    }

    public static SimulationResult run(
            SimulationRequest request,
            List<String> paths,
            Dialogue dialogue,
            PathNames names,
            Progress progress)
            throws WrongUse {
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
                        models -> compiled ? mayRun(request, test, models, names) : List.of(),
                        names,
                        progress);
        if (checked.hasErrors()) {
            return new SimulationResult(checked.result(), Optional.empty(), List.of());
        }
        Model model = checked.lower(progress);
        progress.step("simulating");
        SimulateStep step = new SimulateStep(request, names, dialogue);
        MainComponent main = step.main(checked, model, step.test(model, input));
        List<Watch> watches = Watches.of(request.monitors(), main.component(), checked, model);
        Trace trace = step.run(main, step.test(model, input));
        return new SimulationResult(
                checked.result(), Optional.of(trace), Watched.all(watches, trace));
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
        return models.components().stream().filter(ComponentSymbol::isDeploy).toList();
    }

    private Optional<StreamTest> test(Model model, Optional<TestReference> input) throws WrongUse {
        return input.isPresent() ? Optional.of(input.get().in(model, names)) : Optional.empty();
    }

    private Trace run(MainComponent main, Optional<StreamTest> test) throws WrongUse {
        Network network;
        try {
            network = Network.of(main.component(), main.arguments());
        } catch (ModelError error) {
            Trace nothing = new Trace(main.component(), List.of(), Optional.of(error.getMessage()));
            return record(main, nothing, List.of());
        }
        List<Letter> letters = letters(network, test);
        if (request.engine() == SimulationRequest.Engine.COMPILED) {
            return record(main, Simulation.run(compiled(main), letters), List.of());
        }
        Interpreter interpreter = new Interpreter(main.component(), main.arguments(), choice());
        Trace trace = Simulation.run(watched(interpreter), letters);
        return record(main, trace, interpreter.decisions());
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
        CompiledModel model = CompiledModel.of(main.component(), choosing);
        return new CompiledExecution(model, main.arguments(), request.seed());
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
    private List<Letter> letters(Network network, Optional<StreamTest> test) {
        if (test.isEmpty()) {
            int count = request.slices().orElse(DEFAULT_STEPS);
            return Simulation.randomLetters(network, request.seed(), count, CHANCE_OF_A_MESSAGE);
        }
        List<Letter> letters = new ArrayList<>(test.get().inputs());
        int count = request.slices().orElse(length(test.get()));
        while (letters.size() < count) {
            letters.add(StreamTests.quietAfter(letters, network));
        }
        return letters.subList(0, count);
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
