package arcomat.sim.load;

import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.VarInsnNode;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** The local variables of a method that may hold objects, numbered from 0. */
final class Variables {
    private final Map<Integer, Integer> numbers = new LinkedHashMap<>();
    private final List<Integer> parameters = new ArrayList<>();

    private Variables() {}

    static Variables of(MethodNode method) {
        Variables variables = new Variables();
        int local = 0;
        if ((method.access & Opcodes.ACC_STATIC) == 0) {
            variables.addParameter(local++);
        }
        for (Type type : Type.getArgumentTypes(method.desc)) {
            if (isObject(type)) {
                variables.addParameter(local);
            }
            local += type.getSize();
        }
        if (!hasSubroutines(method)) {
            for (AbstractInsnNode each : method.instructions) {
                if (each.getOpcode() == Opcodes.ASTORE) {
                    variables.add(((VarInsnNode) each).var);
                }
            }
        }
        return variables;
    }

    /** Old compilers' subroutines put addresses of code into variables. */
    private static boolean hasSubroutines(MethodNode method) {
        for (AbstractInsnNode each : method.instructions) {
            if (each.getOpcode() == Opcodes.JSR) {
                return true;
            }
        }
        return false;
    }

    static boolean isObject(Type type) {
        return type.getSort() == Type.OBJECT || type.getSort() == Type.ARRAY;
    }

    private void addParameter(int local) {
        parameters.add(local);
        add(local);
    }

    private void add(int local) {
        numbers.putIfAbsent(local, numbers.size());
    }

    int size() {
        return numbers.size();
    }

    /** Parameters that hold objects, the object of the method among them. */
    List<Integer> parameters() {
        return parameters;
    }

    boolean contains(int local) {
        return numbers.containsKey(local);
    }

    /** Of a local variable that it {@linkplain #contains contains}. */
    int number(int local) {
        return Objects.requireNonNull(numbers.get(local));
    }
}
