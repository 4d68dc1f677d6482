package arcomat.brick;

/** Where a class of a robot's jar comes from. */
public enum Origin {
    GENERATED("generated from models"),
    RUNTIME("runtime of generated code"),
    PLATFORM("platform library"),
    HAND_WRITTEN("written by hand");

    private final String description;

    Origin(String description) {
        this.description = description;
    }

    /** For people: completes "classes that are ...". */
    public String description() {
        return description;
    }
}
