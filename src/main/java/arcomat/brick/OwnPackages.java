package arcomat.brick;

import arcomat.source.Diagnostic;

import java.util.stream.Stream;

/** ARC0913: a class in a package of the brick would hide the brick's own or be hidden by it. */
final class OwnPackages implements BrickLaw {
    private static final String ROOTS = "(java|javax|lejos)/.*";

    @Override
    public String code() {
        return "ARC0913";
    }

    @Override
    public Stream<Diagnostic> findings(Program program) {
        return program.inClasses(
                (file, node) ->
                        node.name.matches(ROOTS)
                                ? Stream.of(
                                        Diagnostic.error(
                                                code(),
                                                file.span(),
                                                file.name()
                                                        + " lies in a package that belongs to the"
                                                        + " brick; move it to one of your own"))
                                : Stream.empty());
    }
}
