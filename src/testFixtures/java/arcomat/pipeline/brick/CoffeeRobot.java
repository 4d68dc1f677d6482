package arcomat.pipeline.brick;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.generate.GeneratedFile;
import arcomat.generate.Generation;
import arcomat.generate.Generator;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.generate.plan.Choosing;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.generate.Implementations;
import arcomat.pipeline.generate.RobotBuilder;
import arcomat.sim.load.Program;
import arcomat.sim.load.ProgramException;
import arcomat.symbols.Scenario;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** A robot of the case study, compiled and packed as the tool does it. */
public record CoffeeRobot(
        Component component,
        Generation generation,
        Implementations implementations,
        RobotBuilder.Result built) {
    public static final List<String> NAMES =
            List.of(
                    "coffee.fetcher.Fetcher",
                    "coffee.dispenser.Dispenser",
                    "coffee.preparer.Preparer");

    private static final Path ROOT = Path.of("models/coffee");
    private static final Map<String, CoffeeRobot> KNOWN = new HashMap<>();

    static synchronized CoffeeRobot of(String name) {
        return KNOWN.computeIfAbsent(name, n -> build(n, "private", "private"));
    }

    /** The same robot, but that the components of its program can be looked at. */
    public static synchronized CoffeeRobot open(String name) {
        return KNOWN.computeIfAbsent(name + " open", n -> build(name, "private", "public static"));
    }

    private static CoffeeRobot build(String name, String modifier, String replacement) {
        Model model = Lowering.lower(Scenario.models(ROOT.toString()));
        Component component = model.component(name).orElseThrow();
        Target target = Target.shipped("lejos").orElseThrow();
        try {
            Implementations implementations =
                    Implementations.find(target, List.of(), new PathNames(Path.of("")));
            Request request =
                    Request.program(component, Choosing.FIRST).with(implementations.texts());
            Generation generation = Generator.generate(request, target);
            assertThat(generation.findings()).isEmpty();
            List<GeneratedFile> files =
                    generation.files().stream()
                            .map(
                                    file ->
                                            new GeneratedFile(
                                                    file.path(),
                                                    opened(file, modifier, replacement)))
                            .toList();
            Generation changed = new Generation(files, List.of(), generation.layout());
            RobotBuilder.Result built = RobotBuilder.build(changed, implementations);
            assertThat(built.findings()).isEmpty();
            return new CoffeeRobot(component, changed, implementations, built);
        } catch (WrongUse e) {
            throw new AssertionError(e);
        }
    }

    private static String opened(GeneratedFile file, String modifier, String replacement) {
        return file.path().endsWith("Program.java")
                ? file.text().replaceFirst(modifier + " (\\w+ whole;)", replacement + " $1")
                : file.text();
    }

    RobotBuilder.Result builtAgain() {
        return RobotBuilder.build(generation, implementations);
    }

    byte[] jar() {
        return built.jars().values().iterator().next();
    }

    /** The jar as a simulated brick takes it. */
    public Program program() {
        try {
            Path file = Files.createTempFile("robot", ".jar");
            try {
                Files.write(file, jar());
                return Program.read(file);
            } finally {
                Files.delete(file);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (ProgramException e) {
            throw new AssertionError(e);
        }
    }

    public String programClass() {
        return generation.layout().programs().get(component.qualifiedName());
    }
}
