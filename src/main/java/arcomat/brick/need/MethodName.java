package arcomat.brick.need;

import org.objectweb.asm.tree.MethodInsnNode;

/**
 * A method as instructions name it.
 *
 * @param owner internal name of the class it is looked up in
 */
record MethodName(String owner, String name, String descriptor) {
    static MethodName of(MethodInsnNode call) {
        return new MethodName(call.owner, call.name, call.desc);
    }

    MethodName in(String other) {
        return new MethodName(other, name, descriptor);
    }

    /** For people: {@code arcomat.nxt.Row.show}. */
    @Override
    public String toString() {
        return owner.replace('/', '.') + "." + name;
    }
}
