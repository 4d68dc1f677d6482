package arcomat.fuzz.process;

import arcomat.fuzz.Dice;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/** Damages files as media, editors and people do who have a reason to. */
final class ByteDamage {
    private static final int LONGEST_PIECE = 60;
    private static final Pattern WORD = Pattern.compile("\\w+|[^\\w\\s]");
    private static final List<String> PIECES =
            List.of(
                    "\0",
                    "\r",
                    "\uffff",
                    "\ud83d\ude00",
                    "-1",
                    "0",
                    "1e999",
                    "NaN",
                    "99999999999999999999",
                    "2147483647",
                    "-2147483648",
                    "../",
                    "../../x",
                    "/etc/passwd",
                    "${x}",
                    "{",
                    "}",
                    "[",
                    "]",
                    "\"",
                    "\\u0000",
                    "%s",
                    "#",
                    "\n",
                    "\n\n",
                    " ",
                    "=",
                    "|",
                    "{0}",
                    "null",
                    "A",
                    "S1",
                    "end");

    private final Dice dice;

    ByteDamage(Dice dice) {
        this.dice = dice;
    }

    /** One to three damages of any kind. */
    byte[] apply(byte[] file) {
        byte[] damaged = file;
        for (int i = dice.below(3); i >= 0; i--) {
            damaged = once(damaged);
        }
        return damaged;
    }

    /** One to three damages that leave a text a text. */
    byte[] applyToText(byte[] file) {
        String text = new String(file, StandardCharsets.UTF_8);
        for (int i = dice.below(3); i >= 0; i--) {
            text = once(text);
        }
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private byte[] once(byte[] file) {
        if (file.length == 0) {
            return bytes(dice.one(PIECES));
        }
        int at = dice.below(file.length);
        int end = Math.min(file.length, at + 1 + dice.below(LONGEST_PIECE));
        return switch (dice.below(8)) {
            case 0 -> Arrays.copyOf(file, at);
            case 1 -> replaced(file, at, end, new byte[0]);
            case 2 -> replaced(file, at, at, Arrays.copyOfRange(file, at, end));
            case 3 -> replaced(file, at, at, bytes(dice.one(PIECES)));
            case 4 -> replaced(file, at, at + 1, new byte[] {(byte) dice.below(256)});
            case 5 -> moved(file, at, end);
            default -> flipped(file, at);
        };
    }

    private byte[] flipped(byte[] file, int at) {
        byte[] other = file.clone();
        other[at] ^= (byte) (1 << dice.below(8));
        return other;
    }

    private byte[] moved(byte[] file, int at, int end) {
        byte[] rest = replaced(file, at, end, new byte[0]);
        int to = dice.below(rest.length + 1);
        return replaced(rest, to, to, Arrays.copyOfRange(file, at, end));
    }

    private static byte[] replaced(byte[] file, int from, int to, byte[] fresh) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.write(file, 0, from);
        bytes.writeBytes(fresh);
        bytes.write(file, to, file.length - to);
        return bytes.toByteArray();
    }

    private String once(String text) {
        List<MatchResult> words = WORD.matcher(text).results().toList();
        if (words.isEmpty()) {
            return dice.one(PIECES);
        }
        MatchResult word = dice.one(words);
        return switch (dice.below(7)) {
            case 0 -> text.substring(0, word.start());
            case 1 -> with(text, word, "");
            case 2 -> with(text, word, word.group() + " " + word.group());
            case 3 -> with(text, word, dice.one(PIECES));
            case 4 -> with(text, word, dice.one(words).group());
            default -> lines(text);
        };
    }

    private static String with(String text, MatchResult word, String fresh) {
        return text.substring(0, word.start()) + fresh + text.substring(word.end());
    }

    /** A line is elsewhere, twice, or gone. */
    private String lines(String text) {
        List<String> lines = new java.util.ArrayList<>(text.lines().toList());
        String line = lines.get(dice.below(lines.size()));
        if (dice.below(3) > 0) {
            lines.remove(line);
        }
        if (dice.below(3) > 0) {
            lines.add(dice.below(lines.size() + 1), line);
        }
        return String.join("\n", lines) + "\n";
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }
}
