package arcomat.brick;

import arcomat.source.Span;

import java.util.Optional;

/**
 * A place where a class names a type or a member.
 *
 * @param where the class or method that does so, for people
 * @param owner internal name of the type, or of the type that the member is looked up in
 * @param member none if only the type is named
 */
record Reference(Span span, String where, String owner, Optional<Member> member) {

    /**
     * @param descriptor of a field or, starting with a parenthesis, of a method
     */
    record Member(String name, String descriptor) {
        boolean isMethod() {
            return descriptor.startsWith("(");
        }
    }
}
