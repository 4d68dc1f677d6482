package arcomat.generate.language;

/**
 * Where a component or message type lives in the generated code. A view that has one shows these
 * words as its own.
 *
 * @param packageName empty for none
 * @param prefix the package as the beginning of an identifier, for languages without packages
 * @param folder the package as the beginning of a path, with a slash at its end unless empty
 */
public record TypeName(String packageName, String prefix, String folder, String name) {

    public static TypeName of(String packageName, String name) {
        String dotted = packageName.isEmpty() ? "" : packageName + ".";
        return new TypeName(packageName, dotted.replace('.', '_'), dotted.replace('.', '/'), name);
    }

    public String qualified() {
        return packageName.isEmpty() ? name : packageName + "." + name;
    }
}
