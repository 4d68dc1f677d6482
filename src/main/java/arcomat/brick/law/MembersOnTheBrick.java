package arcomat.brick.law;

import arcomat.brick.jar.Hierarchy;
import arcomat.brick.jar.JavaNames;
import arcomat.brick.jar.ReferenceSearch.Reference;
import arcomat.brick.jar.RobotProgram;
import arcomat.source.Diagnostic;

import java.util.Optional;
import java.util.stream.Stream;

/**
 * ARC0904: what a robot names is its own or leJOS'. The stub jar makes compilers see to that;
 * classes that were compiled against another library have to be looked through.
 */
final class MembersOnTheBrick extends BrickLaw {
    MembersOnTheBrick() {
        super("ARC0904");
    }

    @Override
    public Stream<Diagnostic> findings(RobotProgram program) {
        Hierarchy hierarchy = new Hierarchy(program);
        return program.references().stream().flatMap(each -> finding(hierarchy, each).stream());
    }

    private Optional<Diagnostic> finding(Hierarchy hierarchy, Reference reference) {
        if (!hierarchy.contains(reference.owner())) {
            return Optional.of(missingType(reference));
        }
        return reference.member().filter(m -> !hierarchy.has(reference.owner(), m)).isPresent()
                ? Optional.of(missingMember(hierarchy, reference))
                : Optional.empty();
    }

    private Diagnostic missingType(Reference reference) {
        return error(
                reference.span(),
                "%s uses %s, a class that leJOS NXJ 0.9.1 does not have; %s",
                reference.where(),
                JavaNames.type(reference.owner()),
                Replacements.ofType(reference.owner()));
    }

    private Diagnostic missingMember(Hierarchy hierarchy, Reference reference) {
        Reference.Member member = reference.member().get();
        return error(
                reference.span(),
                "%s %s %s, which leJOS NXJ 0.9.1 does not have; %s",
                reference.where(),
                member.isMethod() ? "calls" : "uses the field",
                JavaNames.member(reference.owner(), member),
                Replacements.ofMember(hierarchy, reference.owner(), member));
    }
}
