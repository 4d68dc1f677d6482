package arcomat.docs;

import java.util.regex.Pattern;

/** Lines of a page, among them {@code ...}, which stands for any lines. */
record Lines(String text) {
    boolean describe(String whole) {
        return pattern().matcher(whole).matches();
    }

    /** Whether they stand somewhere in a file, at the beginning of one of its lines. */
    boolean areIn(String file) {
        return Pattern.compile("(?m)^" + pattern().pattern()).matcher(file).find();
    }

    private Pattern pattern() {
        StringBuilder regex = new StringBuilder();
        for (String line : text.lines().toList()) {
            regex.append(line.strip().equals("...") ? "(.*\n)*?" : Pattern.quote(line + "\n"));
        }
        return Pattern.compile(regex.toString());
    }
}
