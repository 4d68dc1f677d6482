package arcomat.pipeline.recheck;

import arcomat.symbols.names.Names;
import arcomat.symbols.names.Outline;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * How a file can touch others.
 *
 * @param offers what others may refer to, each as the words that a text must contain to do so: a
 *     name is looked for as it is written, behind a package or behind an import, so that all parts
 *     of the full name are in the text
 * @param mentions the words of its text
 * @param claims what only one file may have
 */
record FileInterface(List<List<String>> offers, Set<String> mentions, Set<String> claims) {
    /** Behind the name of a package: all of it, as in an import. No name has this letter. */
    private static final String ALL = "*";

    static FileInterface of(CheckState.File file) {
        Set<String> claims = new HashSet<>();
        claims.add("file " + file.path().toLowerCase(Locale.ROOT));
        if (file.names().isEmpty()) {
            return new FileInterface(brokenOffers(file.path()), file.mentions(), claims);
        }
        Outline names = file.names().get();
        List<List<String>> offers = new ArrayList<>();
        names.components().stream().findFirst().map(FileInterface::words).ifPresent(offers::add);
        names.diagram().map(FileInterface::words).ifPresent(offers::add);
        names.types().forEach(type -> offers.add(words(withoutDiagram(names, type))));
        for (String component : names.components()) {
            claims.add(javaClass(names.packageName(), component));
        }
        if (!names.packageName().isEmpty()) {
            offers.add(List.of(beside(file.path())));
            return new FileInterface(offers, file.mentions(), claims);
        }
        Set<String> mentions = new HashSet<>(file.mentions());
        mentions.add(beside(file.path()));
        return new FileInterface(offers, mentions, claims);
    }

    /** How a file without a package depends on files beside it that have one. */
    private static String beside(String path) {
        return path.substring(0, path.lastIndexOf('/') + 1) + ALL;
    }

    private static String withoutDiagram(Outline names, String type) {
        return Names.join(names.packageName(), Outline.simple(type));
    }

    /** The parts of a qualified name. */
    static List<String> words(String qualifiedName) {
        return List.of(qualifiedName.split("\\."));
    }

    /** How a text mentions all of a package. */
    static String allOf(String packageName) {
        return packageName.substring(packageName.lastIndexOf('.') + 1) + ALL;
    }

    /**
     * What a file without a tree might define is excused, and so are imports of its folder. Types
     * of a diagram are found by the name of their package alone.
     */
    private static List<List<String>> brokenOffers(String path) {
        int slash = path.lastIndexOf('/');
        int dot = path.lastIndexOf('.');
        String name = (dot > slash ? path.substring(0, dot) : path).replace('/', '.');
        List<List<String>> offers = new ArrayList<>();
        offers.add(List.of(name.substring(slash + 1)));
        int last = name.lastIndexOf('.');
        if (last >= 0) {
            String folder = name.substring(0, last);
            offers.add(List.of(allOf(folder)));
            if (path.endsWith(".cd")) {
                offers.add(List.of(Outline.simple(folder)));
            }
        }
        return offers;
    }

    /** Layers aside: more files than necessary have the same one. */
    private static String javaClass(String packageName, String component) {
        String inPackage =
                packageName.isEmpty() ? component : component.substring(packageName.length() + 1);
        return "class " + packageName + "." + inPackage.replace(".", "");
    }
}
