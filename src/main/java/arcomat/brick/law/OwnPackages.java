package arcomat.brick.law;

import arcomat.brick.jar.RobotProgram;
import arcomat.source.Diagnostic;

import java.util.stream.Stream;

/** ARC0913: a class in a package of the brick would hide the brick's own or be hidden by it. */
final class OwnPackages extends BrickLaw {
    private static final String ROOTS = "(java|javax|lejos)/.*";

    OwnPackages() {
        super("ARC0913");
    }

    @Override
    public Stream<Diagnostic> findings(RobotProgram program) {
        return program.inClasses(
                (file, node) ->
                        node.name.matches(ROOTS)
                                ? Stream.of(
                                        error(
                                                file.span(),
                                                "%s lies in a package that belongs to the brick;"
                                                        + " move it to one of your own",
                                                file.name()))
                                : Stream.empty());
    }
}
