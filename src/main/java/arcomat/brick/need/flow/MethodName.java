package arcomat.brick.need.flow;

import org.objectweb.asm.tree.MethodInsnNode;

/**
 * A method as instructions name it.
 *
 * @param owner internal name of the class it is looked up in
 */
public record MethodName(String owner, String name, String descriptor) {
    public static MethodName of(MethodInsnNode call) {
        return new MethodName(call.owner, call.name, call.desc);
    }

    public MethodName in(String other) {
        return new MethodName(other, name, descriptor);
    }

    /** For people: {@code arcomat.nxt.Row.show}. */
    @Override
    public String toString() {
        return owner.replace('/', '.') + "." + name;
    }
}
