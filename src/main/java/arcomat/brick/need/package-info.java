/**
 * What a program needs of the brick: classes, memory, and time for a slice, predicted from its
 * class files alone. What cannot be known without running the program is not guessed but said to be
 * unknown. Knows instructions and what leJOS' own classes cost, but neither laws nor findings.
 */
package arcomat.brick.need;
