package ${packageName};

/** What the parts of the robot tell each other. */
classdiagram ${component}Signals {
    /** What the wheels are to do. */
    enum Move { forward, turn; }
}
