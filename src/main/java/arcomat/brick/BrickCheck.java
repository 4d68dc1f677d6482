package arcomat.brick;

import arcomat.brick.api.BrickTable;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.List;

/** Checks a robot's jar before it goes to the linker. */
public final class BrickCheck {
    private BrickCheck() {}

    /** All laws at once: whatever is wrong, in one run. */
    public static BrickReport check(RobotJar jar, BrickTable table) {
        return check(Program.read(jar, table));
    }

    /** As above; what is on the brick, but not on a simulated one, is a warning. */
    public static BrickReport checkAlsoForSimulation(RobotJar jar, BrickTable table) {
        Program program = Program.read(jar, table);
        return check(program).with(new SimulationCheck(program).findings());
    }

    private static BrickReport check(Program program) {
        List<Diagnostic> findings =
                BrickLaws.ALL.stream()
                        .flatMap(law -> law.findings(program))
                        .sorted(Diagnostic.ORDER)
                        .distinct()
                        .toList();
        return new BrickReport(findings, shares(program), program.needs());
    }

    private static List<BrickReport.Share> shares(Program program) {
        List<BrickReport.Share> shares = new ArrayList<>();
        for (Origin origin : Origin.values()) {
            List<ClassFile> files =
                    program.files().stream().filter(f -> f.origin() == origin).toList();
            if (!files.isEmpty()) {
                shares.add(
                        new BrickReport.Share(
                                origin,
                                files.size(),
                                files.stream().mapToInt(ClassFile::methods).sum(),
                                files.stream().mapToInt(ClassFile::size).sum()));
            }
        }
        return shares;
    }
}
