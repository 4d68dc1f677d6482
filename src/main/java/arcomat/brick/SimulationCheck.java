package arcomat.brick;

import arcomat.brick.api.BrickTable;
import arcomat.sim.load.SimulatedMembers;
import arcomat.source.Diagnostic;

import org.objectweb.asm.tree.ClassNode;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/**
 * ARC0916: what is on the brick and not on a simulated one. A program that names it would break off
 * with an error of the PC's machine, or reach the PC itself: its files, its network.
 */
public final class SimulationCheck {
    private static final String CODE = "ARC0916";
    private static final String SIMULATION = "arcomat/sim/";

    private final SimulatedMembers simulated = new SimulatedMembers();
    private final Program program;
    private final Hierarchy hierarchy;

    private SimulationCheck(Program program) {
        this.program = program;
        this.hierarchy = new Hierarchy(program);
    }

    /** Errors, for a program that is to be simulated; each type and member is told once. */
    public static List<Diagnostic> check(RobotJar jar, BrickTable table) {
        return new SimulationCheck(Program.read(jar, table)).findings();
    }

    private List<Diagnostic> findings() {
        List<Diagnostic> findings =
                new ArrayList<>(program.inClasses(SimulationCheck::ownPlace).toList());
        Set<String> told = new HashSet<>();
        for (Reference each : program.references()) {
            if (!isSimulated(each) && told.add(missing(each))) {
                findings.add(finding(each));
            }
        }
        findings.sort(Diagnostic.ORDER);
        return findings;
    }

    private static Stream<Diagnostic> ownPlace(ClassFile file, ClassNode node) {
        return node.name.startsWith(SIMULATION)
                ? Stream.of(
                        Diagnostic.error(
                                CODE,
                                file.span(),
                                file.name()
                                        + " lies in a package of the simulated brick; move it to"
                                        + " another one"))
                : Stream.empty();
    }

    /** What leJOS does not have either has its own finding. */
    private boolean isSimulated(Reference reference) {
        if (!hierarchy.contains(reference.owner())) {
            return true;
        }
        if (reference.member().isEmpty()) {
            return isOwn(reference.owner()) || simulated.has(reference.owner());
        }
        Reference.Member member = reference.member().get();
        return !hierarchy.has(reference.owner(), member)
                || hierarchy.withSupertypes(reference.owner()).stream()
                        .anyMatch(type -> offers(type, member));
    }

    private boolean offers(String type, Reference.Member member) {
        return isOwn(type)
                ? hierarchy.declares(type, member)
                : simulated.has(type, member.name(), member.descriptor());
    }

    private boolean isOwn(String type) {
        return program.own(type).isPresent();
    }

    private Diagnostic finding(Reference reference) {
        return Diagnostic.error(
                CODE,
                reference.span(),
                reference.where()
                        + " uses "
                        + missing(reference)
                        + ", which the simulated brick does not have: 'run-brick' and 'world'"
                        + " cannot run this program");
    }

    /** The member, or the whole type. */
    private String missing(Reference reference) {
        return reference
                .member()
                .filter(member -> isOwn(reference.owner()) || simulated.has(reference.owner()))
                .map(member -> Names.member(reference.owner(), member))
                .orElse(Names.type(reference.owner()));
    }
}
