/**
 * What has to hold of a program for the brick: one law, one class, one code. Laws know the robot's
 * classes and what they need; nothing here knows files or commands.
 */
package arcomat.brick.law;
