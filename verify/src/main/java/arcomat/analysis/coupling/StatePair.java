package arcomat.analysis.coupling;

/** A state of each side, by their numbers. */
record StatePair(int left, int right) {}
