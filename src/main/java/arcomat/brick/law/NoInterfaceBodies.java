package arcomat.brick.law;

import arcomat.brick.jar.ClassFile;
import arcomat.brick.jar.RobotProgram;
import arcomat.source.Diagnostic;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.MethodNode;

import java.util.stream.Stream;

/** ARC0903: default methods fail when the brick calls them, static ones crash its machine. */
final class NoInterfaceBodies extends BrickLaw {
    private static final String CONSTANTS = "<clinit>";

    NoInterfaceBodies() {
        super("ARC0903");
    }

    @Override
    public Stream<Diagnostic> findings(RobotProgram program) {
        return program.inClasses(
                (file, node) ->
                        isInterface(node)
                                ? node.methods.stream()
                                        .filter(NoInterfaceBodies::hasBody)
                                        .map(method -> finding(file, method))
                                : Stream.empty());
    }

    private static boolean isInterface(ClassNode node) {
        return (node.access & Opcodes.ACC_INTERFACE) != 0;
    }

    private static boolean hasBody(MethodNode method) {
        return (method.access & Opcodes.ACC_ABSTRACT) == 0 && !method.name.equals(CONSTANTS);
    }

    private Diagnostic finding(ClassFile file, MethodNode method) {
        String kind = (method.access & Opcodes.ACC_STATIC) != 0 ? "static" : "default";
        return error(
                file.span(method),
                "interface %s has the %s method %s, which fails on the brick; move the body to a"
                        + " class",
                file.name(),
                kind,
                method.name);
    }
}
