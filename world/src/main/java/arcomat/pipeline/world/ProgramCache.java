package arcomat.pipeline.world;

import arcomat.generate.CodeLayout;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.brick.JarReader;
import arcomat.pipeline.brick.PluggedDevices;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.MainComponent;
import arcomat.pipeline.generate.BrickCode;
import arcomat.sim.device.SensorName;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.load.Program;
import arcomat.source.Diagnostic;
import arcomat.world.Kind.Program.Form;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Programs and devices of robots, each read or made, and loaded, once for any number of worlds:
 * models are checked once, whatever programs are made of them.
 */
public final class ProgramCache {
    private final Map<String, Models> models = new HashMap<>();
    private final Map<Wanted, Made> programs = new HashMap<>();
    private final Map<Socket, PluggedDevices> devices = new HashMap<>();

    /**
     * A program that a robot is to have.
     *
     * @param name of a component, with arguments where it takes some; empty for a jar
     * @param path of a jar or a model root, as messages show it
     */
    record Wanted(Form form, String name, String path) {}

    /**
     * What came of it.
     *
     * @param program null where a finding says why there is none
     * @param layout where its code has what its models have; empty for a jar that was given
     * @param findings about the program, not about its models
     */
    record Made(
            @Nullable LoadedProgram program,
            Optional<CodeLayout> layout,
            List<Diagnostic> findings) {
        static final Made NOTHING = none(List.of());

        static Made none(List<Diagnostic> findings) {
            return new Made(null, Optional.empty(), findings);
        }
    }

    /** A model root with its meaning, which is null where there are errors. */
    record Models(CheckedModels checked, @Nullable LoweredModels lowered) {
        /** Whether looking again for these would find the same. */
        private boolean serve(Asked asked) {
            return checked.aside().isEmpty()
                    ? checked.loaded().broken().isEmpty()
                    : asked.isIn(checked.workspace());
        }
    }

    private record Socket(SensorName socket, String device) {}

    /**
     * Models, checked.
     *
     * @param root the path, as messages show it
     * @param components that are asked for: files that they do not need may be broken
     */
    synchronized Models models(String root, List<String> components, Session session) {
        Asked asked = Asked.components(components);
        Models known = models.get(root);
        if (known != null && known.serve(asked)) {
            return known;
        }
        CheckedModels checked = CheckedModels.checkToExamine(List.of(root), asked, session);
        Models fresh = new Models(checked, checked.hasErrors() ? null : checked.lower(session));
        models.put(root, fresh);
        return fresh;
    }

    /**
     * @throws WrongUse where there is no such jar or component, or it is no robot's program
     */
    synchronized Made jar(String path, Session session) throws WrongUse {
        Wanted wanted = new Wanted(Form.JAR, "", path);
        Made known = programs.get(wanted);
        if (known == null) {
            known = checked(JarReader.read(path, session.names()), Optional.empty(), List.of());
            programs.put(wanted, known);
        }
        return known;
    }

    /**
     * The program of a component, the same as {@code generate} writes.
     *
     * @param component with arguments, if it takes some
     * @throws WrongUse where there is no such component, or the arguments do not fit it
     */
    synchronized Made component(
            String component, String root, LoweredModels models, Session session) throws WrongUse {
        Wanted wanted = new Wanted(Form.COMPONENT, component, root);
        Made known = programs.get(wanted);
        if (known == null) {
            known = made(MainComponent.find(component, models), models, session);
            programs.put(wanted, known);
        }
        return known;
    }

    /**
     * What is plugged into a socket.
     *
     * @throws WrongUse where there is no such device
     */
    synchronized PluggedDevices device(SensorName socket, String device, PathNames names)
            throws WrongUse {
        Socket plugged = new Socket(socket, device);
        PluggedDevices known = devices.get(plugged);
        if (known == null) {
            known = PluggedDevices.of(Map.of(socket, device), names);
            devices.put(plugged, known);
        }
        return known;
    }

    private static Made made(MainComponent main, LoweredModels models, Session session)
            throws WrongUse {
        BrickCode code = BrickCode.of(main.closed(), models, session);
        if (code.jar().isEmpty()) {
            return Made.none(code.findings());
        }
        BrickCode.Jar jar = code.jar().get();
        JarReader made = JarReader.made(jar.path(), jar.bytes());
        return checked(made, Optional.of(code.layout()), code.findings());
    }

    private static Made checked(JarReader jar, Optional<CodeLayout> layout, List<Diagnostic> before)
            throws WrongUse {
        List<Diagnostic> obstacles = jar.report().obstacles();
        List<Diagnostic> findings = new ArrayList<>(before);
        findings.addAll(obstacles);
        if (!obstacles.isEmpty()) {
            return Made.none(findings);
        }
        Program program = jar.program();
        if (!program.classes().containsKey(program.mainClass())) {
            throw new WrongUse(
                    "'%s' is no robot's jar: it names the main class %s and does not contain it",
                    jar.shown(), program.mainClass());
        }
        return new Made(LoadedProgram.forMany(program), layout, findings);
    }
}
