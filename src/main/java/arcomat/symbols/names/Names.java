package arcomat.symbols.names;

import arcomat.tree.QualifiedName;

/** Arithmetic on qualified names. */
public final class Names {
    private Names() {}

    public static String join(String qualifier, String name) {
        return qualifier.isEmpty() ? name : qualifier + "." + name;
    }

    /** What stands before the last dot; empty for a simple name. */
    public static String qualifier(String name) {
        return name.substring(0, Math.max(0, name.lastIndexOf('.')));
    }

    /** The part behind the first name, with its leading dot; empty for a simple name. */
    static String afterFirst(QualifiedName name) {
        return name.isSimple() ? "" : name.text().substring(first(name).length());
    }

    static String first(QualifiedName name) {
        return name.parts().get(0).text();
    }

    /** The name under which something unnamed goes: that of its type, first letter lower-case. */
    public static String implicit(String typeName) {
        String simple = typeName.substring(typeName.lastIndexOf('.') + 1);
        return Character.toLowerCase(simple.charAt(0)) + simple.substring(1);
    }
}
