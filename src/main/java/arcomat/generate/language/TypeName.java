package arcomat.generate.language;

/**
 * Where a component or message type lives in the generated code.
 *
 * @param packageName empty for none
 */
public record TypeName(String packageName, String name) {
    public String qualified() {
        return packageName.isEmpty() ? name : packageName + "." + name;
    }

    /** The package as the beginning of a path, with a slash at its end unless empty. */
    public String folder() {
        return packageName.isEmpty() ? "" : packageName.replace('.', '/') + "/";
    }

    /** The package as the beginning of an identifier, for languages without packages. */
    public String prefix() {
        return packageName.isEmpty() ? "" : packageName.replace('.', '_') + "_";
    }
}
