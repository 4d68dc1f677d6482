package arcomat.brick;

import arcomat.source.Diagnostic;
import arcomat.source.Span;

import java.util.Optional;
import java.util.stream.Stream;

/**
 * ARC0904: what a robot names is its own or leJOS'. The stub jar makes compilers see to that;
 * classes that were compiled against another library have to be looked through.
 */
final class MembersOnTheBrick implements BrickLaw {
    @Override
    public String code() {
        return "ARC0904";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
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
                reference.where()
                        + " uses "
                        + Names.type(reference.owner())
                        + ", a class that leJOS NXJ 0.9.1 does not have; "
                        + Replacements.ofType(reference.owner()));
    }

    private Diagnostic missingMember(Hierarchy hierarchy, Reference reference) {
        Reference.Member member = reference.member().get();
        return error(
                reference.span(),
                reference.where()
                        + (member.isMethod() ? " calls " : " uses the field ")
                        + Names.member(reference.owner(), member)
                        + ", which leJOS NXJ 0.9.1 does not have; "
                        + Replacements.ofMember(hierarchy, reference.owner(), member));
    }

    private Diagnostic error(Span span, String message) {
        return Diagnostic.error(code(), span, message);
    }
}
