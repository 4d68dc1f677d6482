/* Another. */
component Start { }
