package arcomat.diagram;

import arcomat.model.Type;

/** Types by their short names. */
final class TypeNames {
    private TypeNames() {}

    static String of(Type type) {
        if (type instanceof Type.EnumType enumeration) {
            return enumeration.simpleName();
        }
        return type instanceof Type.ClassType object ? object.simpleName() : type.name();
    }
}
