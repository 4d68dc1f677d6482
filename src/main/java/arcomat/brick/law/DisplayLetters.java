package arcomat.brick.law;

import arcomat.brick.jar.ClassFile;
import arcomat.brick.jar.RobotProgram;
import arcomat.source.Diagnostic;

import org.objectweb.asm.tree.LdcInsnNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.stream.Stream;

/** ARC0915: the display draws ASCII; for any other letter the old one stays on it (measured). */
final class DisplayLetters extends BrickLaw {
    DisplayLetters() {
        super("ARC0915");
    }

    @Override
    public Stream<Diagnostic> findings(RobotProgram program) {
        return program.inInstructions(LdcInsnNode.class, this::inConstant);
    }

    private Stream<Diagnostic> inConstant(ClassFile file, MethodNode method, LdcInsnNode each) {
        return each.cst instanceof String text
                ? text.codePoints()
                        .filter(DisplayLetters::isStrange)
                        .limit(1)
                        .mapToObj(letter -> finding(file, method, each, letter))
                : Stream.empty();
    }

    private Diagnostic finding(ClassFile file, MethodNode method, LdcInsnNode each, int letter) {
        return warning(
                file.span(method, each),
                "%s has a text with '%s', which the brick's display cannot show; use the letters of"
                        + " ASCII",
                file.where(method, each),
                Character.toString(letter));
    }

    /** Control characters are for other purposes than to be seen. */
    private static boolean isStrange(int letter) {
        return letter > '~';
    }
}
