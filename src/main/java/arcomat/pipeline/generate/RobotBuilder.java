package arcomat.pipeline.generate;

import arcomat.brick.BrickCheck;
import arcomat.brick.BrickReport;
import arcomat.brick.ReachableClasses;
import arcomat.brick.api.BrickTable;
import arcomat.brick.api.StubWriter;
import arcomat.brick.jar.RobotJar;
import arcomat.brick.jar.RobotJar.Origin;
import arcomat.brick.jar.RobotJar.RobotClass;
import arcomat.generate.GeneratedFile;
import arcomat.generate.Generation;
import arcomat.pipeline.compile.ClassFiles;
import arcomat.pipeline.compile.Compilation;
import arcomat.pipeline.compile.MemoryCompiler;
import arcomat.pipeline.compile.OversizedCode;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;

/**
 * From generated code to the jars of robots: compiles, packs what a program needs, and checks it.
 */
public final class RobotBuilder {
    private static final String DOES_NOT_COMPILE = "ARC0807";
    private static final String RUNTIME = "arcomat/rt/";

    /** Of a target that makes no programs for the brick. */
    static final Result NOTHING = new Result(List.of(), Map.of(), List.of());

    private final Generation generation;
    private final Implementations implementations;
    private final BrickTable table = BrickTable.leJos();
    private final Map<String, SourceFile> generated = new LinkedHashMap<>();

    private RobotBuilder(Generation generation, Implementations implementations) {
        this.generation = generation;
        this.implementations = implementations;
        for (GeneratedFile file : generation.files()) {
            if (!implementations.all().containsKey(file.path())) {
                generated.put(file.path(), new SourceFile(file.path(), file.text()));
            }
        }
    }

    /**
     * A program for the brick.
     *
     * @param component qualified name of the component that it runs
     * @param jar path of the jar below the output folder
     * @param report what is known about the jar before it is linked
     */
    public record BrickProgram(String component, String jar, BrickReport report) {}

    /**
     * What came of it.
     *
     * @param jars by path
     * @param findings about code that does not compile, and about jars that do not fit
     */
    public record Result(
            List<BrickProgram> robots, Map<String, byte[]> jars, List<Diagnostic> findings) {}

    /**
     * Compiles what was generated along with its implementations, and packs a jar for each robot.
     */
    public static Result build(Generation generation, Implementations implementations) {
        return new RobotBuilder(generation, implementations).build();
    }

    private Result build() {
        Map<String, String> sources = new LinkedHashMap<>();
        generation.files().forEach(file -> sources.put(file.path(), file.text()));
        Compilation compilation =
                MemoryCompiler.compile(sources, implementations.texts(), classesOf(table));
        if (!compilation.problems().isEmpty()) {
            List<Diagnostic> findings = new ArrayList<>();
            compilation.problems().stream().map(this::finding).distinct().forEach(findings::add);
            return new Result(List.of(), Map.of(), findings);
        }
        return pack(compilation);
    }

    /** What a brick has, as far as a compiler has to know it. */
    public static ClassFiles classesOf(BrickTable table) {
        StubWriter stubs = new StubWriter(table);
        return new ClassFiles(name -> table.type(name).map(stubs::write), table::isPackage);
    }

    private Result pack(Compilation compilation) {
        List<BrickProgram> robots = new ArrayList<>();
        Map<String, byte[]> jars = new TreeMap<>();
        List<Diagnostic> findings = new ArrayList<>();
        Map<String, String> programs = new TreeMap<>(generation.layout().programs());
        programs.forEach(
                (component, main) -> {
                    List<RobotClass> classes = classes(main.replace('.', '/'), compilation);
                    String path = path(component);
                    BrickReport report = BrickCheck.check(new RobotJar(path, classes), table);
                    robots.add(new BrickProgram(component, path, report));
                    jars.put(path, JarWriter.write(main, classes));
                    findings.addAll(report.findings());
                });
        return new Result(robots, jars, findings);
    }

    private List<RobotClass> classes(String main, Compilation compilation) {
        List<RobotClass> classes = new ArrayList<>();
        for (String name : ReachableClasses.from(main, compilation.classes())) {
            String path = Objects.requireNonNull(compilation.sources().get(name));
            classes.add(
                    new RobotClass(
                            name + ".class",
                            Objects.requireNonNull(compilation.classes().get(name)),
                            origin(path),
                            source(path)));
        }
        return classes;
    }

    private Origin origin(String path) {
        if (implementations.own().containsKey(path)) {
            return Origin.HAND_WRITTEN;
        }
        if (!implementations.shipped().containsKey(path)) {
            return Origin.GENERATED;
        }
        return path.startsWith(RUNTIME) ? Origin.RUNTIME : Origin.PLATFORM;
    }

    private Optional<SourceFile> source(String path) {
        return Optional.ofNullable(implementations.all().get(path))
                .or(() -> Optional.ofNullable(generated.get(path)));
    }

    /** {@code Fetcher.jar}; with its package where two robots have the same name. */
    private String path(String component) {
        String simple = simpleName(component);
        long namesakes =
                generation.layout().programs().keySet().stream()
                        .filter(other -> simpleName(other).equals(simple))
                        .count();
        return (namesakes > 1 ? component : simple) + ".jar";
    }

    private static String simpleName(String component) {
        return component.substring(component.lastIndexOf('.') + 1);
    }

    private Diagnostic finding(Compilation.Problem problem) {
        return OversizedCode.finding(problem, generation.layout()).orElseGet(() -> wrong(problem));
    }

    private Diagnostic wrong(Compilation.Problem problem) {
        SourceFile file =
                source(problem.path()).orElseGet(() -> new SourceFile(problem.path(), ""));
        return Diagnostic.error(
                DOES_NOT_COMPILE,
                problem.in(file),
                "this does not compile for the brick, which has Java 6 and the classes of leJOS NXJ"
                        + " 0.9.1: "
                        + problem.message());
    }
}
