package arcomat.pipeline.generate;

import arcomat.generate.CodeLayout;
import arcomat.generate.Generation;
import arcomat.generate.Generator;
import arcomat.generate.Request;
import arcomat.generate.Target;
import arcomat.generate.plan.Choosing;
import arcomat.model.Component;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.LoweredModels;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * The program of one component for the brick, the same as {@code generate} writes, and not written.
 *
 * @param layout where it has what the models have
 * @param jar empty exactly where a finding says why there is none
 * @param findings about the code, not about the models
 */
public record BrickCode(CodeLayout layout, Optional<Jar> jar, List<Diagnostic> findings) {
    private static final String TARGET = "lejos";

    public BrickCode {
        findings = List.copyOf(findings);
    }

    /** A jar in memory, by its path below an output folder. */
    @SuppressWarnings("ArrayRecordComponent") // who compares jars compares their classes
    public record Jar(String path, byte[] bytes) {}

    /**
     * Makes the program of a component.
     *
     * @param component one that takes no arguments
     * @throws WrongUse where implementations of the user cannot be read
     */
    public static BrickCode of(Component component, LoweredModels models, Session session)
            throws WrongUse {
        session.progress().step("making the program of " + component.qualifiedName());
        Target target = Targets.find(TARGET, session.names());
        Implementations own = implementations(target, models, session);
        Request request = Request.program(component, Choosing.FIRST).with(own.texts());
        Generation generation = Generator.generate(request, target);
        if (generation.findings().stream().anyMatch(Diagnostic::isError)) {
            return new BrickCode(generation.layout(), Optional.empty(), generation.findings());
        }
        RobotBuilder.Result built = RobotBuilder.build(generation, own);
        List<Diagnostic> findings = new ArrayList<>(generation.findings());
        findings.addAll(built.findings());
        Optional<Jar> jar =
                built.jars().isEmpty()
                        ? Optional.empty()
                        : Optional.of(jar(built.robots().get(0).jar(), built.jars()));
        return new BrickCode(generation.layout(), jar, findings);
    }

    /** The main classes of all programs that models have, by the components that they run. */
    public static Map<String, String> programs(LoweredModels models, Session session)
            throws WrongUse {
        Target target = Targets.find(TARGET, session.names());
        Request all = Request.all(models.own(), Choosing.FIRST);
        Implementations own = implementations(target, models, session);
        return Generator.generate(all.with(own.texts()), target).layout().programs();
    }

    private static Implementations implementations(
            Target target, LoweredModels models, Session session) throws WrongUse {
        PathNames names = session.names();
        return Implementations.find(target, models.checked().loaded().roots(names), names);
    }

    private static Jar jar(String path, Map<String, byte[]> jars) {
        return new Jar(path, Objects.requireNonNull(jars.get(path)));
    }
}
