package arcomat.rt;

import java.util.ArrayList;

/** Says what was seen, and what would have been allowed. */
final class Accusation {
    private final Requirement requirement;
    private final Messages seen;
    private final Runs runs;
    private final boolean[] delayed;

    Accusation(Requirement requirement, boolean[] delayed) {
        this.requirement = requirement;
        this.seen = requirement.seen;
        this.runs = requirement.runs;
        this.delayed = delayed;
    }

    /**
     * What no run has promised.
     *
     * @param late whether it was seen on outputs with a delay, or on those without
     */
    String unexpected(boolean late) {
        boolean[] said = flags();
        ArrayList<String> shown = new ArrayList<String>();
        for (int port = 0; port < said.length; port++) {
            said[port] = delayed[port] == late && isPromised(port);
            if (said[port]) {
                shown.add(told(port, seen, 0));
            }
        }
        ArrayList<String> allowed = new ArrayList<String>();
        for (int run = 0; run < runs.size(); run++) {
            String alternative = alternative(run, said);
            if (!contains(allowed, alternative)) {
                allowed.add(alternative);
            }
        }
        return " forbids " + joined(shown, ", ") + "; it allows " + joined(allowed, " or ");
    }

    /** Makes an array; in a method, whose size the prediction of memory knows by its name. */
    private boolean[] flags() {
        return new boolean[delayed.length];
    }

    private static boolean contains(ArrayList<String> texts, String text) {
        for (int i = 0; i < texts.size(); i++) {
            if (texts.get(i).equals(text)) {
                return true;
            }
        }
        return false;
    }

    /** Whether any run says something about a port. */
    private boolean isPromised(int port) {
        boolean said = false;
        for (int run = 0; run < runs.size(); run++) {
            said |= runs.promises().count(run, port) != Messages.ANYTHING;
        }
        return said;
    }

    private String alternative(int run, boolean[] said) {
        ArrayList<String> promised = new ArrayList<String>();
        for (int port = 0; port < said.length; port++) {
            if (said[port]) {
                promised.add(told(port, runs.promises(), run));
            }
        }
        return joined(promised, ", ") + " (" + cause(run) + ")";
    }

    private String cause(int run) {
        int origin = runs.origin(run);
        return origin == Runs.TAKEN
                ? runs.cause(run)
                : "no transition fits in "
                        + requirement.name(origin)
                        + ", completion "
                        + runs.cause(run);
    }

    /** What outputs without delay show, as {@code y = 1, z = 2}. */
    String sentAtOnce() {
        ArrayList<String> sent = new ArrayList<String>();
        for (int port = 0; port < delayed.length; port++) {
            if (!delayed[port] && seen.count(0, port) > 0) {
                sent.add(told(port, seen, 0));
            }
        }
        return joined(sent, ", ");
    }

    private String told(int port, Messages messages, int row) {
        return requirement.ports[port] + " = " + text(port, messages, row);
    }

    private String text(int port, Messages messages, int row) {
        int count = messages.count(row, port);
        if (count <= 0) {
            return count == 0 ? "--" : count == Messages.ANY_MESSAGE ? "?" : "anything";
        }
        ArrayList<String> texts = new ArrayList<String>();
        int start = messages.start(row, port);
        for (int i = start; i < start + count; i++) {
            texts.add(text(port, messages.values().number(i), messages.values().object(i)));
        }
        return joined(texts, ", ");
    }

    private String text(int port, long number, Object object) {
        if (object instanceof String) {
            return quoted((String) object, '"');
        }
        return object == null ? requirement.text(port, number) : object.toString();
    }

    private static String joined(ArrayList<String> texts, String separator) {
        String joined = "";
        for (int i = 0; i < texts.size(); i++) {
            joined += (i == 0 ? "" : separator) + texts.get(i);
        }
        return joined;
    }

    /** As models write it, on one line. */
    static String quoted(String text, char quote) {
        StringBuilder quoted = new StringBuilder();
        quoted.append(quote);
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            int escaped = "\n\r\t\\".indexOf(c);
            if (escaped >= 0) {
                quoted.append('\\').append("nrt\\".charAt(escaped));
            } else {
                quoted.append(c == quote ? "\\" : "").append(c);
            }
        }
        return quoted.append(quote).toString();
    }
}
