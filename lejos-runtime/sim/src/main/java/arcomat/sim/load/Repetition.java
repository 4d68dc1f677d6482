package arcomat.sim.load;

import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.Handle;
import org.objectweb.asm.Label;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.Type;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * Changes a class so that it can begin again, as if it had just been loaded: what Java does once,
 * behind the scenes, becomes methods. The initializer becomes one that others call where Java would
 * have run it, and another one forgets all that is static. Everything else stays as it is.
 *
 * <p>A class that cannot is refused: a new beginning that is almost one would be a run that is
 * almost the same.
 */
final class Repetition extends ClassVisitor {
    /** Called wherever Java would look whether a class has begun. */
    static final String READY = "$ready";

    /** Called when a brick is through with a class. */
    static final String FORGET = "$forget";

    /** What the initializer is called now. */
    static final String BEGIN = "$begin";

    /** Begins: those above first. */
    static final String FIRST = "$first";

    private static final String BEGUN = "$begun";
    private static final String CLASSES = "arcomat/sim/inside/BrickClasses";
    private static final String INITIALIZER = "<clinit>";
    private static final String NOTHING = "()V";
    private static final int HIDDEN = Opcodes.ACC_STATIC | Opcodes.ACC_SYNTHETIC;

    /** Asked for these, Java keeps an answer with the class, or begins it behind our back. */
    private static final Set<String> KEPT_BY_JAVA =
            Set.of("newInstance", "forName", "getEnumConstants", "getField", "getDeclaredField");

    private final Beginnings beginnings;
    private final List<FieldToForget> forgotten = new ArrayList<>();
    private String owner = "";
    private boolean isInterface;
    private boolean hasInitializer;

    private record FieldToForget(String name, String descriptor) {}

    private Repetition(ClassVisitor next, Beginnings beginnings) {
        super(Opcodes.ASM9, next);
        this.beginnings = beginnings;
    }

    /**
     * The class file of a class that can begin again.
     *
     * @throws Unrepeatable where it cannot
     */
    static byte[] of(byte[] classFile, Beginnings beginnings) {
        ClassWriter writer = new ClassWriter(ClassWriter.COMPUTE_MAXS);
        new ClassReader(classFile).accept(new Repetition(writer, beginnings), 0);
        return writer.toByteArray();
    }

    @Override
    public void visit(
            int version,
            int access,
            String name,
            String signature,
            String superName,
            String[] interfaces) {
        if ((access & Opcodes.ACC_ENUM) != 0) {
            throw new Unrepeatable(name + " is an enum, whose constants Java keeps");
        }
        owner = name;
        isInterface = (access & Opcodes.ACC_INTERFACE) != 0;
        super.visit(version, access, name, signature, superName, interfaces);
    }

    @Override
    public FieldVisitor visitField(
            int access, String name, String descriptor, String signature, @Nullable Object value) {
        boolean isStatic = (access & Opcodes.ACC_STATIC) != 0;
        if (!isStatic || value != null && (access & Opcodes.ACC_FINAL) != 0) {
            return super.visitField(access, name, descriptor, signature, value);
        }
        if (isInterface || value != null) {
            throw new Unrepeatable(owner + "." + name + " cannot be given a value again");
        }
        forgotten.add(new FieldToForget(name, descriptor));
        return super.visitField(access & ~Opcodes.ACC_FINAL, name, descriptor, signature, null);
    }

    @Override
    public MethodVisitor visitMethod(
            int access, String name, String descriptor, String signature, String[] exceptions) {
        if (name.equals("finalize") && descriptor.equals(NOTHING)) {
            throw new Unrepeatable(owner + " has a finalizer, which runs when it likes");
        }
        boolean isInitializer = name.equals(INITIALIZER);
        hasInitializer |= isInitializer;
        MethodVisitor method =
                super.visitMethod(
                        isInitializer ? Opcodes.ACC_PRIVATE | HIDDEN : access,
                        isInitializer ? BEGIN : name,
                        descriptor,
                        signature,
                        exceptions);
        return new Uses(method);
    }

    @Override
    public void visitEnd() {
        if (hasInitializer) {
            super.visitField(HIDDEN, BEGUN, "Z", null, null).visitEnd();
            forgotten.add(new FieldToForget(BEGUN, "Z"));
            writeReady();
            writeFirst();
        }
        if (!forgotten.isEmpty()) {
            writeForget();
        }
        super.visitEnd();
    }

    private MethodVisitor hidden(int access, String name) {
        MethodVisitor code = cv.visitMethod(access | HIDDEN, name, NOTHING, null, null);
        code.visitCode();
        return code;
    }

    private void writeReady() {
        MethodVisitor code = hidden(Opcodes.ACC_PUBLIC, READY);
        Label ready = new Label();
        code.visitFieldInsn(Opcodes.GETSTATIC, owner, BEGUN, "Z");
        code.visitJumpInsn(Opcodes.IFNE, ready);
        code.visitMethodInsn(Opcodes.INVOKESTATIC, owner, FIRST, NOTHING, false);
        code.visitLabel(ready);
        code.visitFrame(Opcodes.F_SAME, 0, null, 0, null);
        end(code);
    }

    /**
     * As Java does it: a class that is asked for by its own initializer has begun already, and one
     * whose initializer has failed never begins.
     */
    private void writeFirst() {
        MethodVisitor code = hidden(Opcodes.ACC_PRIVATE, FIRST);
        Label start = new Label();
        Label end = new Label();
        Label handler = new Label();
        code.visitTryCatchBlock(start, end, handler, null);
        code.visitLdcInsn(written());
        call(code, "check", "(Ljava/lang/String;)V");
        code.visitLabel(start);
        setBegun(code, true);
        String above = beginnings.above(owner);
        if (above != null) {
            ready(code, above);
        }
        code.visitMethodInsn(Opcodes.INVOKESTATIC, owner, BEGIN, NOTHING, false);
        code.visitLabel(end);
        code.visitInsn(Opcodes.RETURN);
        code.visitLabel(handler);
        code.visitFrame(Opcodes.F_FULL, 0, null, 1, new Object[] {"java/lang/Throwable"});
        setBegun(code, false);
        code.visitLdcInsn(written());
        call(code, "failed", "(Ljava/lang/Throwable;Ljava/lang/String;)Ljava/lang/Error;");
        code.visitInsn(Opcodes.ATHROW);
        code.visitMaxs(0, 0);
        code.visitEnd();
    }

    private String written() {
        return owner.replace('/', '.');
    }

    private static void call(MethodVisitor code, String method, String descriptor) {
        code.visitMethodInsn(Opcodes.INVOKESTATIC, CLASSES, method, descriptor, false);
    }

    private void setBegun(MethodVisitor code, boolean value) {
        code.visitInsn(value ? Opcodes.ICONST_1 : Opcodes.ICONST_0);
        code.visitFieldInsn(Opcodes.PUTSTATIC, owner, BEGUN, "Z");
    }

    private void writeForget() {
        MethodVisitor code = hidden(Opcodes.ACC_PUBLIC, FORGET);
        for (FieldToForget field : forgotten) {
            code.visitInsn(nothing(Type.getType(field.descriptor())));
            code.visitFieldInsn(Opcodes.PUTSTATIC, owner, field.name(), field.descriptor());
        }
        end(code);
    }

    private static void end(MethodVisitor code) {
        code.visitInsn(Opcodes.RETURN);
        code.visitMaxs(0, 0);
        code.visitEnd();
    }

    private static int nothing(Type type) {
        return switch (type.getSort()) {
            case Type.LONG -> Opcodes.LCONST_0;
            case Type.DOUBLE -> Opcodes.DCONST_0;
            case Type.FLOAT -> Opcodes.FCONST_0;
            case Type.ARRAY, Type.OBJECT -> Opcodes.ACONST_NULL;
            default -> Opcodes.ICONST_0;
        };
    }

    private static void ready(MethodVisitor code, String type) {
        code.visitMethodInsn(Opcodes.INVOKESTATIC, type, READY, NOTHING, false);
    }

    /** Lets a class begin before one of it is made, or something static of it is used. */
    private final class Uses extends MethodVisitor {
        Uses(MethodVisitor next) {
            super(Opcodes.ASM9, next);
        }

        private void begin(@Nullable String type) {
            if (type == null || beginnings.hasBegunFor(owner, type)) {
                return;
            }
            if (!beginnings.isSeenBy(owner, type)) {
                throw new Unrepeatable(owner + " uses " + type + ", which it does not see");
            }
            ready(mv, type);
        }

        /** Behind it: frames name a NEW by its place. What is not yet made is seen by nobody. */
        @Override
        public void visitTypeInsn(int opcode, String type) {
            super.visitTypeInsn(opcode, type);
            if (opcode == Opcodes.NEW) {
                begin(beginnings.ofMaking(type));
            }
        }

        @Override
        public void visitFieldInsn(int opcode, String type, String name, String descriptor) {
            if (opcode == Opcodes.GETSTATIC || opcode == Opcodes.PUTSTATIC) {
                begin(beginnings.ofUsing(type, name + descriptor));
            }
            super.visitFieldInsn(opcode, type, name, descriptor);
        }

        @Override
        public void visitMethodInsn(
                int opcode, String type, String name, String descriptor, boolean ofInterface) {
            if (asksJava(type, name) && !BrickLoader.isInside(written())) {
                throw new Unrepeatable(owner + " calls " + type + "." + name);
            }
            if (opcode == Opcodes.INVOKESTATIC) {
                begin(beginnings.ofUsing(type, name + descriptor));
            }
            super.visitMethodInsn(opcode, type, name, descriptor, ofInterface);
        }

        private static boolean asksJava(String type, String method) {
            return type.startsWith("java/lang/reflect/")
                    || type.startsWith("java/lang/invoke/")
                    || type.equals("java/lang/Class") && KEPT_BY_JAVA.contains(method);
        }

        /** Methods that a call site finds for itself: those of the class have begun with it. */
        @Override
        public void visitInvokeDynamicInsn(
                String name, String descriptor, Handle bootstrap, Object... arguments) {
            for (Object argument : arguments) {
                if (argument instanceof Handle handle
                        && !handle.getOwner().equals(owner)
                        && !handle.getOwner().startsWith("java/")) {
                    throw new Unrepeatable(owner + " refers to a method of " + handle.getOwner());
                }
            }
            super.visitInvokeDynamicInsn(name, descriptor, bootstrap, arguments);
        }
    }
}
