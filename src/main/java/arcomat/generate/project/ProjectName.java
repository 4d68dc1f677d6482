package arcomat.generate.project;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The name of a project, which is that of its folder; package and robot are called after it.
 *
 * @param text as it was written
 */
public record ProjectName(String text) {
    private static final Pattern NAME = Pattern.compile("[A-Za-z][A-Za-z0-9]*");
    private static final Pattern WORD = Pattern.compile("[A-Za-z0-9]+");

    /** Packages that belong to somebody else. */
    private static final List<String> TAKEN = List.of("java", "javax", "nxt", "lejos", "arcomat");

    /** Whether a package and a component can be called so. */
    public boolean isFine() {
        return NAME.matcher(text).matches() && !TAKEN.contains(packageName());
    }

    /** Another one that is fine, and as near as can be. */
    public String suggestion() {
        List<String> words = new ArrayList<>();
        Matcher word = WORD.matcher(text);
        while (word.find()) {
            words.add(word.group());
        }
        StringBuilder name = new StringBuilder();
        for (String each : words) {
            name.append(name.isEmpty() ? each : capitalised(each));
        }
        boolean begins = !name.isEmpty() && Character.isLetter(name.charAt(0));
        ProjectName guess = new ProjectName(begins ? name.toString() : "Robot" + name);
        boolean helps = guess.isFine() && !guess.equals(this);
        return helps ? guess.text() : guess.text() + "Robot";
    }

    /** The full name of the component that decides. */
    public String logic() {
        return packageName() + "." + component() + "Pilot";
    }

    String packageName() {
        return text.toLowerCase(Locale.ROOT);
    }

    String component() {
        return capitalised(text);
    }

    private static String capitalised(String word) {
        return word.substring(0, 1).toUpperCase(Locale.ROOT) + word.substring(1);
    }
}
