package arcomat.check.law;

/** The kinds of element that carry stereotypes, by the words of the language. */
public enum Carrier {
    COMPONENT("a component"),
    PORT("a port"),
    SUBCOMPONENT("a subcomponent"),
    CONNECTOR("a connector"),
    TIMING("a timing clause"),
    AUTOCONNECT("an autoconnect clause"),
    AUTOINSTANTIATE("an autoinstantiate clause"),
    /** An automaton, or what is translated into one. */
    AUTOMATON("a behaviour"),
    STATE("a state"),
    CLASS_DIAGRAM("a class diagram"),
    TYPE("a type"),
    ATTRIBUTE("an attribute"),
    ASSOCIATION("an association");

    private final String words;

    Carrier(String words) {
        this.words = words;
    }

    /** The place with its article, as messages name it. */
    public String words() {
        return words;
    }
}
