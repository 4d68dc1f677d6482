package arcomat.brick;

import arcomat.brick.api.BrickTable;
import arcomat.brick.jar.ClassFile;
import arcomat.brick.jar.RobotJar;
import arcomat.brick.jar.RobotJar.Origin;
import arcomat.brick.jar.RobotProgram;
import arcomat.brick.law.BrickLaws;
import arcomat.brick.law.SimulationCheck;
import arcomat.source.Diagnostic;

import java.util.Arrays;
import java.util.List;

/** Checks a robot's jar before it goes to the linker. */
public final class BrickCheck {
    private BrickCheck() {}

    /** All laws at once: whatever is wrong, in one run. */
    public static BrickReport check(RobotJar jar, BrickTable table) {
        return check(RobotProgram.read(jar, table));
    }

    /** As above; what is on the brick, but not on a simulated one, is a warning. */
    public static BrickReport checkAlsoForSimulation(RobotJar jar, BrickTable table) {
        RobotProgram program = RobotProgram.read(jar, table);
        return check(program).with(new SimulationCheck(program).findings());
    }

    private static BrickReport check(RobotProgram program) {
        List<Diagnostic> findings =
                BrickLaws.ALL.stream()
                        .flatMap(law -> law.findings(program))
                        .sorted(Diagnostic.ORDER)
                        .distinct()
                        .toList();
        return new BrickReport(findings, shares(program), program.needs());
    }

    private static List<BrickReport.Share> shares(RobotProgram program) {
        return Arrays.stream(Origin.values())
                .map(origin -> share(origin, program))
                .filter(share -> share.classes() > 0)
                .toList();
    }

    private static BrickReport.Share share(Origin origin, RobotProgram program) {
        List<ClassFile> files = program.files().stream().filter(f -> f.origin() == origin).toList();
        return new BrickReport.Share(
                origin,
                files.size(),
                files.stream().mapToInt(ClassFile::methods).sum(),
                files.stream().mapToInt(ClassFile::size).sum());
    }
}
