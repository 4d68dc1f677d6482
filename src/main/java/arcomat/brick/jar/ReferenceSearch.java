package arcomat.brick.jar;

import arcomat.source.Span;

import org.objectweb.asm.Type;
import org.objectweb.asm.tree.AbstractInsnNode;
import org.objectweb.asm.tree.ClassNode;
import org.objectweb.asm.tree.FieldInsnNode;
import org.objectweb.asm.tree.LdcInsnNode;
import org.objectweb.asm.tree.MethodInsnNode;
import org.objectweb.asm.tree.MethodNode;
import org.objectweb.asm.tree.MultiANewArrayInsnNode;
import org.objectweb.asm.tree.TryCatchBlockNode;
import org.objectweb.asm.tree.TypeInsnNode;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Collects what a class names and the linker would look for. Generic signatures, annotations and
 * debug information are not among it.
 */
public final class ReferenceSearch {
    /**
     * A place where a class names a type or a member.
     *
     * @param where the class or method that does so, for people
     * @param owner internal name of the type, or of the type that the member is looked up in
     * @param member none if only the type is named
     */
    public record Reference(Span span, String where, String owner, Optional<Member> member) {

        /**
         * @param descriptor of a field or, starting with a parenthesis, of a method
         */
        public record Member(String name, String descriptor) {
            public boolean isMethod() {
                return descriptor.startsWith("(");
            }

            boolean isCalled(String otherName, String otherDescriptor) {
                return name.equals(otherName) && descriptor.equals(otherDescriptor);
            }
        }
    }

    private final ClassFile file;
    private final List<Reference> found = new ArrayList<>();

    private ReferenceSearch(ClassFile file) {
        this.file = file;
    }

    /** In the order of the class file. */
    static List<Reference> of(ClassFile file, ClassNode node) {
        ReferenceSearch references = new ReferenceSearch(file);
        references.inHead(node);
        node.methods.forEach(references::inMethod);
        return references.found;
    }

    private void inHead(ClassNode node) {
        Span span = file.span();
        if (node.superName != null) {
            type(span, file.name(), Type.getObjectType(node.superName));
        }
        node.interfaces.forEach(name -> type(span, file.name(), Type.getObjectType(name)));
        node.fields.forEach(
                field -> type(span, file.name() + "." + field.name, Type.getType(field.desc)));
    }

    private void inMethod(MethodNode method) {
        Span span = file.span(method);
        String where = file.where(method);
        Type type = Type.getMethodType(method.desc);
        type(span, where, type.getReturnType());
        for (Type parameter : type.getArgumentTypes()) {
            type(span, where, parameter);
        }
        method.exceptions.forEach(name -> type(span, where, Type.getObjectType(name)));
        for (TryCatchBlockNode block : method.tryCatchBlocks) {
            if (block.type != null) {
                type(
                        file.span(method, block.handler),
                        file.where(method, block.handler),
                        Type.getObjectType(block.type));
            }
        }
        for (AbstractInsnNode instruction : method.instructions) {
            inInstruction(method, instruction);
        }
    }

    private void inInstruction(MethodNode method, AbstractInsnNode instruction) {
        if (instruction instanceof TypeInsnNode i) {
            type(method, i, Type.getObjectType(i.desc));
        } else if (instruction instanceof MultiANewArrayInsnNode i) {
            type(method, i, Type.getType(i.desc));
        } else if (instruction instanceof LdcInsnNode i && i.cst instanceof Type type) {
            type(method, i, type);
        } else if (instruction instanceof FieldInsnNode i) {
            member(method, i, i.owner, i.name, i.desc);
        } else if (instruction instanceof MethodInsnNode i) {
            member(method, i, i.owner, i.name, i.desc);
        }
    }

    private void type(MethodNode method, AbstractInsnNode instruction, Type type) {
        type(file.span(method, instruction), file.where(method, instruction), type);
    }

    private void type(Span span, String where, Type type) {
        Type element = type.getSort() == Type.ARRAY ? type.getElementType() : type;
        if (element.getSort() == Type.OBJECT) {
            found.add(new Reference(span, where, element.getInternalName(), Optional.empty()));
        }
    }

    /** Arrays have the members of objects, and every array can be cloned. */
    private void member(
            MethodNode method,
            AbstractInsnNode each,
            String owner,
            String name,
            String descriptor) {
        if (owner.startsWith("[")) {
            type(method, each, Type.getObjectType(owner));
            return;
        }
        found.add(
                new Reference(
                        file.span(method, each),
                        file.where(method, each),
                        owner,
                        Optional.of(new Reference.Member(name, descriptor))));
    }
}
