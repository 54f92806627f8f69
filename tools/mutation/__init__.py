"""Mutation testing: are there faults in a module that its own tests do not see?"""
