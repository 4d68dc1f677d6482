package arcomat.brick;

import arcomat.brick.jar.RobotJar.Origin;
import arcomat.brick.law.SimulationCheck;
import arcomat.brick.need.Needs;
import arcomat.source.Diagnostic;
import arcomat.source.Severity;

import java.util.List;
import java.util.stream.Stream;

/**
 * What is known about a robot's jar before it is linked.
 *
 * @param findings in the order of {@link Diagnostic#ORDER}; the jar fits if there is no error
 * @param shares the jar's classes by origin, in the order of {@link Origin}; none without a class
 * @param needs of the linked program; the machine has room for {@link Needs#MOST_CLASSES}
 */
public record BrickReport(List<Diagnostic> findings, List<Share> shares, Needs needs) {
    /**
     * The classes of one origin.
     *
     * @param bytes size of their class files
     */
    public record Share(Origin origin, int classes, int methods, int bytes) {}

    public BrickReport {
        findings = List.copyOf(findings);
        shares = List.copyOf(shares);
    }

    /** The same with further findings. */
    public BrickReport with(List<Diagnostic> more) {
        List<Diagnostic> all =
                Stream.concat(findings.stream(), more.stream()).sorted(Diagnostic.ORDER).toList();
        return new BrickReport(all, shares, needs);
    }

    /**
     * What speaks against running the jar on a simulated brick, where that was looked at; it may
     * run if there is nothing.
     */
    public List<Diagnostic> obstacles() {
        return fits()
                ? findings.stream()
                        .filter(each -> each.code().equals(SimulationCheck.CODE))
                        .map(each -> each.withSeverity(Severity.ERROR))
                        .toList()
                : findings.stream().filter(Diagnostic::isError).toList();
    }

    public boolean fits() {
        return findings.stream().noneMatch(Diagnostic::isError);
    }

    /** Number of class files in the jar. */
    public int classes() {
        return shares.stream().mapToInt(Share::classes).sum();
    }

    /** Size of all class files. */
    public int bytes() {
        return shares.stream().mapToInt(Share::bytes).sum();
    }
}
